// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "augicp/core/words.h"
#include "augicp/eval/association.h"

namespace augicp {

// How the truth is read at the stamps of the estimate.
enum class TruthReading {
  Nearest,       // its pose of the nearest stamp, see associate()
  Interpolated,  // between two of its poses at most twice max_difference_s apart, see pose_at()
};
template <>
inline constexpr auto kWords<TruthReading> = std::to_array<Word<TruthReading>>(
    {{TruthReading::Nearest, "nearest"}, {TruthReading::Interpolated, "interpolated"}});

// The estimated and the true pose of a moment. Each is world_from_camera; the two worlds may differ.
struct MatchedPose {
  double stamp_s = 0.0;  // of the estimate, time offset included
  Rigid3 estimate, truth;
};

// The poses that both trajectories have, in the order of their stamps; at least one. Throws std::invalid_argument if
// stamps do not increase (see check_order), if nothing matches, and if few poses match but most would if one of the two
// had its stamps in milli-, micro- or nanoseconds.
std::vector<MatchedPose> match_poses(const Trajectory& estimate, const Trajectory& truth,
                                     const AssociationOptions& options = {},
                                     TruthReading reading = TruthReading::Nearest);

}  // namespace augicp
