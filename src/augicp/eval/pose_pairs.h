// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "augicp/core/words.h"
#include "augicp/eval/matched_poses.h"

namespace augicp {

enum class DeltaUnit {
  Frames,   // matched poses; a pose without a match does not count
  Seconds,  // difference of the estimate's stamps
  Metres,   // length of the true path between the matched poses
};
template <>
inline constexpr auto kWords<DeltaUnit> = std::to_array<Word<DeltaUnit>>({{DeltaUnit::Frames, "frames"},
                                                                          {DeltaUnit::Seconds, "seconds"},
                                                                          {DeltaUnit::Metres, "metres"}});

// The distance of the two poses of a relative error.
struct DeltaOptions {
  double delta = 1.0;  // in the unit below; a whole number for frames
  DeltaUnit unit = DeltaUnit::Frames;
  // False: a pair from every pose. True: each pair starts at the end of the one before, the first at the first pose.
  bool consecutive = false;

  // Throws std::invalid_argument naming the first field out of its range.
  void check() const;
};

struct PosePair {
  std::size_t first = 0, second = 0;  // first < second
};

// The pairs of poses that are delta apart, ordered by their first pose. Empty if the trajectory is shorter.
//
// From every pose: the second pose is the later one whose distance from the first is nearest to delta (of two equally
// near ones the earlier). Frames must be exact; in the other units a pair more than a tenth of delta off is dropped.
// evo does the same in frames and metres (all_pairs, rel_delta_tol = 0.1), except that by default its path is the
// estimate's (see pairs_from_reference); here the pairs are the same for every estimate. The TUM benchmark's
// evaluate_rpe.py (fixed_delta) has no tolerance, and drops pairs that end at the last pose.
//
// Consecutive: the second pose is the first that is at least delta away. evo does the same, except that in metres it
// begins delta after the start.
std::vector<PosePair> pairs_at_delta(std::span<const MatchedPose> poses, const DeltaOptions& options = {});

}  // namespace augicp
