// SPDX-License-Identifier: MIT
#include "augicp/synthetic/town.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>

#include "augicp/testing/matchers.h"

namespace augicp::synthetic {
namespace {

using testing::NearPose;

TEST(TownLoop, ALapHasItsLengthAndCloses) {
  for (const double length : {200.0, 500.0}) {
    TownOptions options;
    options.length = length;
    const TownLoop loop = town_loop(options);
    double way = 0.0;
    for (double time_s = 0.0; time_s < loop.lap_s; time_s += 0.02)
      way += (loop.world_from_sensor(time_s + 0.02).translation - loop.world_from_sensor(time_s).translation).norm();
    // The right lane is longer than the centre line: by its distance, times a revolution.
    EXPECT_NEAR(way, length + 2.0 * 3.14159 * 1.75, 0.5);
    EXPECT_THAT(loop.world_from_sensor(loop.lap_s), NearPose(loop.world_from_sensor(0.0), 1e-6, 1e-6));
  }
}

// No jumps: neither of the pose nor of the speed.
TEST(TownLoop, TheDriveIsSmooth) {
  const TownOptions options;
  const TownLoop loop = town_loop(options);
  constexpr double kStep_s = 0.05;
  for (double time_s = 0.0; time_s < loop.lap_s; time_s += kStep_s) {
    const Rigid3 motion = inverse(loop.world_from_sensor(time_s)) * loop.world_from_sensor(time_s + kStep_s);
    EXPECT_LT(motion.translation.norm(), 1.001 * options.speed * kStep_s);
    EXPECT_GT(motion.translation.norm(), 0.49 * options.speed * kStep_s);
    EXPECT_NEAR(motion.translation.y(), 0.0, 0.02);  // along its own x
    EXPECT_LT(angle_between(motion, Rigid3{}), 0.6 * kStep_s);
  }
}

// Nothing stands where the sensor drives, and all six motions are seen everywhere.
TEST(TownLoop, TheRoadIsFreeAndTheHousesAreNear) {
  for (const double length : {200.0, 500.0}) {
    TownOptions options;
    options.length = length;
    const TownLoop loop = town_loop(options);
    Lidar lidar;
    lidar.num_rings = 8;
    lidar.num_azimuths = 120;
    for (double time_s = 0.0; time_s < loop.lap_s; time_s += 1.0) {
      const Sweep sweep = scan(loop.world, lidar, loop.world_from_sensor, 1, time_s);
      EXPECT_GT(sweep.cloud.size(), 500u);
      for (const Vec3f& point : sweep.cloud.points) EXPECT_GT(point.norm(), 1.0f) << "at " << time_s << " s";
    }
  }
}

TEST(TownLoop, TrafficMovesAndCanBeLeftOut) {
  TownOptions options;
  EXPECT_FALSE(town_loop(options).world.moving.empty());
  options.has_traffic = false;
  EXPECT_TRUE(town_loop(options).world.moving.empty());
  const double inf = std::numeric_limits<double>::infinity(), nan = std::numeric_limits<double>::quiet_NaN();
  for (const double length : {100.0, 2e5, inf, nan}) {
    options.length = length;
    EXPECT_THROW(town_loop(options), std::invalid_argument) << length;
  }
}

}  // namespace
}  // namespace augicp::synthetic
