// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "augicp/eval/association.h"

namespace augicp {

// How the truth is read at the stamps of the estimate.
enum class TruthReading {
  Nearest,       // its pose of the nearest stamp, see associate()
  Interpolated,  // between two of its poses at most twice max_difference_s apart, see pose_at()
};

// What was estimated of a moment, and what was true. Each pose is world_from_camera, the two worlds need not be one.
struct MatchedPose {
  double stamp_s = 0.0;  // of the estimate, with the time offset
  Rigid3 estimate, truth;
};

// The poses that both trajectories have, in the order of their stamps; at least one. Throws std::invalid_argument where
// stamps do not increase (see check_order), where nothing matches, and where few match but most would if one of the two
// had its stamps in milli-, micro- or nanoseconds.
std::vector<MatchedPose> match_poses(const Trajectory& estimate, const Trajectory& truth,
                                     const AssociationOptions& options = {},
                                     TruthReading reading = TruthReading::Nearest);

}  // namespace augicp
