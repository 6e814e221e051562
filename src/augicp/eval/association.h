// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <vector>

#include "augicp/geometry/trajectory.h"

namespace augicp {

struct AssociationOptions {
  double max_difference_s = 0.02;  // a larger difference of stamps means different moments
  double time_offset_s = 0.0;      // added to the estimate's stamps, if its clock differs from the truth's

  // Throws std::invalid_argument naming the first field out of its range.
  void check() const;
};

// Indices of two poses of one moment.
struct StampPair {
  std::size_t estimate = 0, truth = 0;
};

// Pairs by stamp, one to one, ordered by the estimate's index. Of all pairs whose stamps differ by at most
// max_difference_s the closest is taken first, then the closest of the rest (of equally close ones the earlier). This
// is the definition of the TUM benchmark's associate.py, except that it excludes a difference of exactly the maximum.
// Takes O(n log n).
//
// evo takes, for each pose of the shorter trajectory, the nearest of the longer one. The two agree unless one pose is
// the nearest of two. evo then uses it twice; this function gives it to the closer one, and the other may get the
// second nearest. This happens only if stamps of the longer trajectory are missing, or both have about the same rate.
std::vector<StampPair> associate(const Trajectory& estimate, const Trajectory& truth,
                                 const AssociationOptions& options = {});

}  // namespace augicp
