// SPDX-License-Identifier: MIT
// Shared by the tests of LiDAR odometry: a small LiDAR, and options for one thread.
#pragma once

#include "augicp/odometry/lidar_odometry.h"
#include "augicp/synthetic/lidar.h"

namespace augicp::testing {

inline constexpr double kSweep_s = 0.1;

inline synthetic::Lidar small_lidar() {
  synthetic::Lidar lidar;
  lidar.num_rings = 32;
  lidar.num_azimuths = 360;
  lidar.sweep_s = kSweep_s;
  return lidar;
}

inline LidarOptions one_thread() {
  LidarOptions options;
  options.num_threads = 1;
  return options;
}

}  // namespace augicp::testing
