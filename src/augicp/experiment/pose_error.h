// SPDX-License-Identifier: MIT
#pragma once

#include "augicp/geometry/rigid3.h"

namespace augicp {

// The true motion of a frame is read between poses less than this apart, seconds.
inline constexpr double kMaxTruthGap_s = 0.1;

// Error of a motion.
struct PoseError {
  double translation = 0.0;  // metres
  double rotation = 0.0;     // radians in [0, pi]
};

// For E = truth^-1 found: the length of its translation, which is the distance between both translations, and its
// angle.
inline PoseError pose_error(const Rigid3& found, const Rigid3& truth) {
  return {(found.translation - truth.translation).norm(), angle_between(found, truth)};
}

inline bool is_within(const PoseError& error, const PoseError& limit) {
  return error.translation < limit.translation && error.rotation < limit.rotation;
}

}  // namespace augicp
