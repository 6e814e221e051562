// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

#include "augicp/eval/matched_poses.h"

namespace augicp {

// What the errors of an estimate leave out: poses that no true pose can be compared with, and poses that are not there.
struct Coverage {
  std::size_t num_outside = 0;    // poses of the estimate before the first true one or after the last
  std::size_t num_unmatched = 0;  // poses between these without a true pose of the same moment
  std::size_t num_holes = 0;      // longer times between two poses of the estimate than usual, as if poses were missing
  std::size_t num_missing = 0;    // poses that would fill the holes at the usual time between two poses
  double longest_hole_s = 0.0;    // between the poses around it; 0: none
};

// num_matched: poses of the estimate that match, see match_poses(). With TruthReading::Nearest a pose is outside only
// if it is farther than max_difference_s from the first and the last true pose.
Coverage coverage_of(const Trajectory& estimate, const Trajectory& truth, std::size_t num_matched,
                     const AssociationOptions& options, TruthReading reading);

}  // namespace augicp
