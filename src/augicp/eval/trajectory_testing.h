// SPDX-License-Identifier: MIT
// Trajectories that the tests of this module share.
#pragma once

#include <cmath>

#include "augicp/geometry/rotation.h"
#include "augicp/geometry/trajectory.h"
#include "augicp/testing/poses.h"

namespace augicp::testing {

inline constexpr double kStart_s = 1305031452.0;

// The pose of a camera that wanders a few metres and looks around, at seconds after its start.
inline Rigid3 wandering_pose(double time_s) {
  const Vec3d turn(0.4 * std::sin(0.7 * time_s), 0.9 * std::sin(0.3 * time_s), 0.5 * std::cos(1.1 * time_s));
  return {rotation_exp(turn), {std::sin(0.5 * time_s), 0.3 * std::cos(0.9 * time_s), 0.2 * time_s}};
}

inline Trajectory wandering(double rate_hz = 30.0, double duration_s = 5.0, double start_s = 0.0) {
  Trajectory trajectory;
  for (int i = 0; i < duration_s * rate_hz; ++i)
    trajectory.push_back({kStart_s + start_s + i / rate_hz, wandering_pose(start_s + i / rate_hz)});
  return trajectory;
}

// The same poses in another world.
inline Trajectory moved(const Rigid3& new_from_old, Trajectory trajectory) {
  for (StampedPose& pose : trajectory) pose.world_from_camera = new_from_old * pose.world_from_camera;
  return trajectory;
}

// An estimate with an error of its own in each pose.
inline Trajectory disturbed(Trajectory trajectory, double angle_rad = 0.02, double distance_m = 0.03) {
  std::mt19937 generator(11);
  for (StampedPose& pose : trajectory)
    pose.world_from_camera = pose.world_from_camera * random_motion(generator, angle_rad * uniform(generator, 0.0, 1.0),
                                                                    distance_m * uniform(generator, 0.0, 1.0));
  return trajectory;
}

}  // namespace augicp::testing
