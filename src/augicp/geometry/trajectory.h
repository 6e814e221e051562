// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include "augicp/geometry/rigid3.h"

namespace augicp {

// Where the camera was at a time. The frame it is told in is called world here; for an estimate that is the first
// camera.
struct StampedPose {
  double stamp_s = 0.0;
  Rigid3 world_from_camera;
};

// Poses in the order of their stamps, which increase strictly.
using Trajectory = std::vector<StampedPose>;

// Throws std::invalid_argument naming the first pose whose stamp is not finite or not above the one before it.
void check_order(const Trajectory& trajectory);

// The pose on the way from one to the other: at share 0 the first, at 1 the second. Translations along the straight
// line, rotations along the shortest arc.
Rigid3 interpolate(const Rigid3& first, const Rigid3& second, double share);

// The pose at a time between two of the trajectory's, nothing before its first and after its last, and nothing where
// the poses around it are more than max_gap_s apart.
std::optional<Rigid3> pose_at(const Trajectory& trajectory, double stamp_s, double max_gap_s);

}  // namespace augicp
