// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "augicp/geometry/rigid3.h"

namespace augicp {

// The pose of the camera at a time, in a frame called world. For an estimate this is the frame of the first camera.
struct StampedPose {
  double stamp_s = 0.0;
  Rigid3 world_from_camera;
};

// Poses in the order of their stamps. Stamps increase strictly.
using Trajectory = std::vector<StampedPose>;

// A motion between two poses of a sequence that is known from elsewhere.
struct ReferencePair {
  std::size_t first = 0, second = 0;  // places of the poses, from 0
  Rigid3 first_from_second;
};

// Throws std::invalid_argument naming the first pose whose stamp is not finite or not above the one before it.
void check_order(const Trajectory& trajectory);

// The pose between two poses: the first at share 0, the second at share 1. Translations follow the straight line,
// rotations the shortest arc.
Rigid3 interpolate(const Rigid3& first, const Rigid3& second, double share);

// The pose at a time, interpolated between the two poses around it. Empty before the first and after the last pose, and
// if the poses around it are more than max_gap_s apart.
std::optional<Rigid3> pose_at(const Trajectory& trajectory, double stamp_s, double max_gap_s);

}  // namespace augicp
