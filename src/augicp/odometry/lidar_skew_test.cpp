// SPDX-License-Identifier: MIT
// LidarOdometry with scans that have times of points and are not skewed: taken at once, or deskewed before.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "augicp/geometry/rotation.h"
#include "augicp/odometry/lidar_odometry.h"
#include "augicp/odometry/lidar_testing.h"
#include "augicp/synthetic/lidar.h"
#include "augicp/synthetic/outdoor_scenes.h"
#include "augicp/testing/repeats.h"
#include "augicp/testing/scenes.h"

namespace augicp {
namespace {

using synthetic::Motion;
using testing::kSweep_s;

synthetic::Lidar lidar_of(int num_azimuths) {
  synthetic::Lidar lidar;
  lidar.num_rings = 32;
  lidar.num_azimuths = num_azimuths;
  lidar.sweep_s = kSweep_s;
  return lidar;
}

// The largest distance between found and true places, metres.
double worst_of_scans_at_once(const testing::Scene& scene, const Motion& motion, int num_scans,
                              const synthetic::Lidar& lidar) {
  LidarOptions options;
  options.num_threads = 1;
  LidarOdometry odometry(options);
  const Rigid3 first_from_world = inverse(motion(0.0));
  double worst = 0.0;
  for (int k = 0; k < num_scans; ++k) {
    const double stamp_s = k * kSweep_s;
    const synthetic::Sweep scan = synthetic::scan({scene, {}}, lidar, synthetic::standing_at(motion(stamp_s)),
                                                  static_cast<unsigned>(k + 1), stamp_s);
    const FrameReport report = odometry.add(stamp_s, scan.cloud, shares_from_times(scan.times_s));
    EXPECT_TRUE(has_pose(report.status)) << "scan " << k;
    const Rigid3 off = inverse(first_from_world * motion(stamp_s)) * report.world_from_camera;
    worst = std::max(worst, off.translation.norm());
  }
  return worst;
}

// With the first scan that would be bent, not with the third.
TEST(LidarSkew, StraightScansAreTakenAsTheyComeFromTheFirstMotionOn) {
  const testing::Scene street = synthetic::street(5);
  for (const double start_s : {0.0, 0.45}) {
    const Motion motion = [&](double time_s) {
      const double distance = 8.0 * std::max(0.0, time_s - start_s);
      return street.world_from_camera * Rigid3{Eigen::Quaterniond::Identity(), {distance, 0.0, 0.0}};
    };
    EXPECT_LT(worst_of_scans_at_once(street, motion, 9, lidar_of(360)), 0.03) << "starts at " << start_s << " s";
  }
}

// What the rings see of the room turns with the sensor, and hardly shows its height. When it starts to turn, the gate
// is wide.
TEST(LidarSkew, ASensorThatTurnsInARoomStaysAtItsHeight) {
  const Motion motion = [](double time_s) {
    const double moving_s = std::max(0.0, time_s - 0.6);
    const Rigid3 moved{rotation_exp({0.0, 0.0, 1.57 * moving_s}), {0.5 * moving_s, 0.0, 0.0}};
    return Rigid3{Eigen::Quaterniond::Identity(), {0.0, 0.0, 1.2}} * moved;
  };
  synthetic::Lidar lidar = lidar_of(720);
  lidar.range_sigma = 0.02;
  for (const unsigned seed : testing::cases({1u, 2u, 3u}, 1))
    EXPECT_LT(worst_of_scans_at_once(testing::room(seed), motion, 16, lidar), 0.15) << "room " << seed;
}

}  // namespace
}  // namespace augicp
