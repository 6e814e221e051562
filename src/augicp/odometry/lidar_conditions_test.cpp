// SPDX-License-Identifier: MIT
// LidarOdometry under conditions that runs meet: dropped scans, standstill, starting while moving, traffic.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>
#include <random>
#include <vector>

#include "augicp/geometry/rotation.h"
#include "augicp/odometry/lidar_odometry.h"
#include "augicp/odometry/lidar_testing.h"
#include "augicp/synthetic/lidar.h"
#include "augicp/synthetic/outdoor_scenes.h"
#include "augicp/testing/matchers.h"
#include "augicp/testing/repeats.h"

namespace augicp {
namespace {

using synthetic::Motion;
using testing::kSweep_s;
using testing::NearPose;
using testing::small_lidar;

synthetic::World street_world() { return {synthetic::street(5), {}}; }

Motion from_start(const Rigid3& motion_of_one_second) {
  return synthetic::moving_evenly(street_world().scene.world_from_camera, motion_of_one_second);
}

Motion straight(double speed) { return from_start({Eigen::Quaterniond::Identity(), {speed, 0.0, 0.0}}); }

struct Drive {
  synthetic::World world;
  Motion motion;
  std::vector<int> sweeps;  // numbers of those that arrive
  LidarOptions options;
};

std::vector<int> first(int count) {
  std::vector<int> all(static_cast<std::size_t>(count));
  std::iota(all.begin(), all.end(), 0);
  return all;
}

std::vector<FrameReport> tracked(const Drive& drive) {
  LidarOptions options = drive.options;
  options.num_threads = 1;
  LidarOdometry odometry(options);
  std::vector<FrameReport> reports;
  for (const int k : drive.sweeps) {
    const double begin_s = k * kSweep_s;
    const synthetic::Sweep sweep =
        synthetic::scan(drive.world, small_lidar(), drive.motion, static_cast<unsigned>(k + 1), begin_s);
    reports.push_back(odometry.add(begin_s, sweep.cloud, shares_from_times(sweep.times_s)));
  }
  return reports;
}

// Each sweep after the first is tracked, and the sensor is where it truly was in the middle of the sweep, in the frame
// of the middle of the first.
void expect_true_poses(const Drive& drive, double max_angle_rad, double max_distance_m) {
  const std::vector<FrameReport> reports = tracked(drive);
  const Rigid3 first_from_world = inverse(drive.motion((drive.sweeps[0] + 0.5) * kSweep_s));
  for (std::size_t k = 0; k < reports.size(); ++k) {
    EXPECT_EQ(reports[k].status, k == 0 ? FrameStatus::Started : FrameStatus::Tracked) << "sweep " << drive.sweeps[k];
    const Rigid3 true_one = first_from_world * drive.motion((drive.sweeps[k] + 0.5) * kSweep_s);
    EXPECT_THAT(reports[k].world_from_camera, NearPose(true_one, max_angle_rad, max_distance_m))
        << "sweep " << drive.sweeps[k];
  }
}

TEST(LidarConditions, DroppedScans) {
  expect_true_poses({street_world(), straight(6.0), {0, 1, 2, 5, 6, 10, 11, 12}, {}}, 0.003, 0.03);
}

TEST(LidarConditions, StartingWhileMoving) {
  expect_true_poses({street_world(), straight(15.0), first(6), {}}, 0.003, 0.08);
}

TEST(LidarConditions, StartingWhileTurning) {
  expect_true_poses({street_world(), from_start({rotation_exp({0.0, 0.0, 1.0}), {2.0, 0.0, 0.0}}), first(6), {}}, 0.004,
                    0.04);
}

// Root mean square of how far the points of the last sweep, straightened with the motion found, are from where the true
// motion puts them at that moment.
double straightening_error(const Drive& drive, const FrameReport& report, PoseInstant pose_at) {
  const int last = drive.sweeps.back();
  const double begin_s = last * kSweep_s;
  const synthetic::Sweep sweep =
      synthetic::scan(drive.world, small_lidar(), drive.motion, static_cast<unsigned>(last + 1), begin_s);
  const double first_s = sweep.times_s.front(), last_s = sweep.times_s.back();
  const double moment_s = pose_at == PoseInstant::Begin ? first_s
                          : pose_at == PoseInstant::End ? last_s
                                                        : 0.5 * (first_s + last_s);
  const Cloud expected = synthetic::straightened(sweep, drive.motion, begin_s, moment_s);
  if (!report.motion) return std::numeric_limits<double>::infinity();
  const Cloud straight = deskewed(sweep.cloud, shares_from_times(sweep.times_s), report, pose_at, 1);
  double sum_sq = 0.0;
  for (std::size_t i = 0; i < straight.size(); ++i)
    sum_sq += (straight.origin + (straight.points[i] - expected.points[i]).cast<double>()).squaredNorm();
  return std::sqrt(sum_sq / static_cast<double>(straight.size()));
}

// 15 m/s and 90 degrees a second, along a line and on an arc. They move points by more than half a metre.
TEST(LidarConditions, SweepsOfFastTurnsAreStraightenedToACentimetre) {
  const Rigid3 start = street_world().scene.world_from_camera;
  const Motion on_an_arc = [&](double time_s) {
    const double rate = 0.5 * std::numbers::pi, radius = 15.0 / rate, angle = rate * time_s;
    return start *
           Rigid3{rotation_exp({0.0, 0.0, angle}), {radius * std::sin(angle), radius * (1.0 - std::cos(angle)), 0.0}};
  };
  const Motion along_a_line = from_start({rotation_exp({0.0, 0.0, 0.5 * std::numbers::pi}), {15.0, 0.0, 0.0}});
  const Drive line{street_world(), along_a_line, first(8), {}}, arc{street_world(), on_an_arc, first(4), {}};
  const FrameReport on_the_line = tracked(line).back();
  EXPECT_LT(straightening_error(line, on_the_line, PoseInstant::Middle), 0.01);
  // There the error of half a sweep's motion is added.
  for (const PoseInstant pose_at : {PoseInstant::Begin, PoseInstant::End})
    EXPECT_LT(straightening_error(line, on_the_line, pose_at), 0.02) << name_of(pose_at);
  EXPECT_LT(straightening_error(arc, tracked(arc).back(), PoseInstant::Middle), 0.01);
}

// Leaves: two of five points are anywhere on their rays, within a twentieth of their range.
Cloud among_leaves(Cloud scan, unsigned seed) {
  std::mt19937 generator(seed);
  std::uniform_real_distribution<float> ratio(0.95f, 1.05f), share(0.0f, 1.0f);
  for (Vec3f& point : scan.points)
    if (share(generator) < 0.4f) point *= ratio(generator);
  return scan;
}

TEST(LidarConditions, StandingAmongLeavesIsTracked) {
  LidarOdometry odometry;
  synthetic::Lidar lidar = small_lidar();
  lidar.num_azimuths = 1000;
  const Rigid3 place = street_world().scene.world_from_camera;
  for (unsigned k = 0; k < 5; ++k) {
    const Cloud scan = among_leaves(synthetic::scan(street_world().scene, lidar, place, k + 1), k + 1);
    const FrameReport report = odometry.add(k * kSweep_s, scan);
    if (k == 0) continue;
    EXPECT_EQ(report.status, FrameStatus::Tracked);
    EXPECT_LT(report.overlap, 0.25);
    EXPECT_THAT(report.world_from_camera, NearPose(Rigid3{}, 0.003, 0.03));
  }
}

// In the hand: the rate of the turn changes by 180 degrees per second within a tenth of a second. Each sweep shows
// itself how it was bent; by the poses of whole scans alone, half of them were up to 5 cm and 1.6 degrees off.
TEST(LidarConditions, JerksDuringSweepsAreSeen) {
  const Rigid3 start = street_world().scene.world_from_camera;
  const Motion motion = [&](double time_s) {
    const double moving_s = std::max(0.0, time_s - 0.3), w = 2.0 * std::numbers::pi * 1.6;
    const double yaw = 0.3 * (1.0 - std::cos(w * moving_s));
    return start * Rigid3{rotation_exp({0.0, 0.0, yaw}), {0.5 * moving_s, 0.0, 0.0}};
  };
  expect_true_poses({street_world(), motion, first(14), {}}, 0.006, 0.03);
}

// One reading of the second and of the fifth sweep is farther than a grid of voxels has cells for.
TEST(LidarConditions, ReadingsAtImpossibleRangesChangeNothing) {
  LidarOdometry odometry;
  const Motion motion = straight(5.0);
  const Rigid3 first_from_world = inverse(motion(0.5 * kSweep_s));
  for (int k = 0; k < 6; ++k) {
    const double begin_s = k * kSweep_s;
    synthetic::Sweep sweep =
        synthetic::scan(street_world(), small_lidar(), motion, static_cast<unsigned>(k + 1), begin_s);
    if (k % 3 == 1) sweep.cloud.points[7] = {3e9f, -3e9f, 3e9f};
    const FrameReport report = odometry.add(begin_s, sweep.cloud, shares_from_times(sweep.times_s));
    const Rigid3 true_one = first_from_world * motion(begin_s + 0.5 * kSweep_s);
    EXPECT_THAT(report.world_from_camera, NearPose(true_one, 0.003, 0.04)) << "sweep " << k;
  }
}

// It stands for a second, and starts with 4 m/s^2.
TEST(LidarConditions, StartingFromStandstill) {
  const Rigid3 start = street_world().scene.world_from_camera;
  const Motion motion = [&](double time_s) {
    const double t = std::max(0.0, time_s - 1.0);
    return start * Rigid3{Eigen::Quaterniond::Identity(), {2.0 * t * t, 0.0, 0.0}};
  };
  expect_true_poses({street_world(), motion, first(18), {}}, 0.003, 0.03);
}

synthetic::MovingObject vehicle(const Vec3d& place, const Vec3d& velocity, const Vec3d& size) {
  synthetic::MovingObject object;
  add_box(object.scene, {Eigen::Quaterniond::Identity(), {0.0, 0.0, 0.5 * size.z()}}, size);
  object.world_from_object =
      synthetic::moving_evenly({Eigen::Quaterniond::Identity(), place}, {Eigen::Quaterniond::Identity(), velocity});
  return object;
}

// A van ahead with the sensor's own speed, oncoming cars, and a lorry that overtakes.
synthetic::World busy_street() {
  synthetic::World world = street_world();
  const double x = world.scene.world_from_camera.translation.x();
  world.moving = {vehicle({x + 9.0, 0.0, 0.0}, {5.0, 0.0, 0.0}, {5.5, 2.0, 2.6}),
                  vehicle({x + 14.0, 2.6, 0.0}, {-9.0, 0.0, 0.0}, {4.4, 1.8, 1.5}),
                  vehicle({x + 30.0, 2.6, 0.0}, {-9.0, 0.0, 0.0}, {4.2, 1.8, 1.6}),
                  vehicle({x - 14.0, -2.9, 0.0}, {11.0, 0.0, 0.0}, {9.0, 2.4, 3.4})};
  return world;
}

TEST(LidarConditions, MovingTraffic) { expect_true_poses({busy_street(), straight(5.0), first(12), {}}, 0.003, 0.04); }

TEST(LidarConditions, StandingInTraffic) {
  expect_true_poses({busy_street(), synthetic::standing_at(street_world().scene.world_from_camera), first(12), {}},
                    0.001, 0.006);
}

TEST(LidarConditions, EveryNthScanIsCheckedAgainstAKeyframeFartherBack) {
  Drive drive{street_world(), straight(6.0), first(10), {}};
  drive.options.check_every = 3;
  const std::vector<FrameReport> reports = tracked(drive);
  const Rigid3 first_from_world = inverse(drive.motion(0.5 * kSweep_s));
  for (std::size_t k = 0; k < reports.size(); ++k) {
    ASSERT_EQ(reports[k].drift.has_value(), k > 0 && k % 3 == 0) << "sweep " << k;
    if (!reports[k].drift) continue;
    const DriftCheck& check = *reports[k].drift;
    EXPECT_EQ(check.keyframe_stamp_s, 0.0);
    EXPECT_FALSE(check.contradicts);
    EXPECT_THAT(check.keyframe_from_sensor,
                NearPose(first_from_world * drive.motion((static_cast<double>(k) + 0.5) * kSweep_s), 0.003, 0.03));
    EXPECT_LT(check.drift_m, 0.03);
  }
}

TEST(LidarConditions, TheSelfCheckCanBeLeftOut) {
  Drive drive{street_world(), straight(6.0), first(12), {}};
  drive.options.check_every = 0;
  for (const FrameReport& report : tracked(drive)) EXPECT_FALSE(report.drift);
}

// Forwards and backwards over ten scans, many times. Where scans are only noise apart, single points
// fall into further voxels; without a bound each of the keyframes would add its few hundred.
TEST(LidarConditions, OverKnownPlacesTheMapDoesNotGrow) {
  constexpr int kNumPlaces = 10, kRound = 2 * (kNumPlaces - 1), kNumScans = testing::repeats(240, 90);
  synthetic::Lidar lidar = small_lidar();
  lidar.num_azimuths = 240;
  std::vector<Cloud> scans;
  scans.reserve(kNumPlaces);
  for (int k = 0; k < kNumPlaces; ++k)
    scans.push_back(
        synthetic::scan(street_world().scene, lidar, straight(6.0)(0.25 * k), static_cast<unsigned>(k + 1)));
  LidarOptions options;
  options.num_threads = 1;
  options.voxel_size = 0.6;
  LidarOdometry odometry(options);
  std::size_t after_two_rounds = 0;
  int num_keyframes = 0;
  for (int k = 0; k < kNumScans; ++k) {
    const int place = std::abs((k + kNumPlaces - 1) % kRound - (kNumPlaces - 1));
    const FrameReport report = odometry.add(0.25 * k, scans[static_cast<std::size_t>(place)]);
    ASSERT_EQ(report.status, k == 0 ? FrameStatus::Started : FrameStatus::Tracked) << "scan " << k;
    num_keyframes += report.is_keyframe;
    if (k == 2 * kRound) after_two_rounds = odometry.num_voxels();
  }
  EXPECT_GT(num_keyframes, kNumScans / 4);
  EXPECT_GT(after_two_rounds, 1000u);
  EXPECT_LT(odometry.num_voxels(), after_two_rounds + after_two_rounds / 50);
}

// Points of the map in the frame of the world, inside an upright box on the ground.
std::size_t num_in_box(const LidarOdometry& odometry, const Rigid3& world_from_first, const Vec3d& foot,
                       const Vec3d& size) {
  std::size_t count = 0;
  const Cloud map = odometry.map();
  for (const Vec3f& point : map.points) {
    const Vec3d from_foot = world_from_first * (map.origin + point.cast<double>()) - foot;
    const bool is_inside = std::abs(from_foot.x()) < 0.5 * size.x() && std::abs(from_foot.y()) < 0.5 * size.y() &&
                           from_foot.z() > 0.4 && from_foot.z() < size.z();
    count += is_inside;
  }
  return count;
}

// A lorry that stands ahead on the left, and drives away after half a second: the map holds it, and loses a part of it
// once keyframes have seen what was behind. How much stays depends on where the road behind it is seen.
TEST(LidarConditions, OfWhatDrivesAwayLessStaysInTheMap) {
  const Vec3d sensor = street_world().scene.world_from_camera.translation;
  const double beside = sensor.y() > 0.0 ? -2.2 : 2.2;  // in the road, free of what is parked
  const Vec3d place(sensor.x() + 12.0, sensor.y() + beside, 0.0);
  const Vec3d size(7.0, 2.0, 3.2);
  std::size_t num_left[2] = {0, 0};  // without and with removal
  for (const bool is_removed : {false, true}) {
    synthetic::World world = street_world();
    world.moving = {vehicle(Vec3d::Zero(), Vec3d::Zero(), size)};
    world.moving[0].world_from_object = [&](double time_s) {
      return Rigid3{Eigen::Quaterniond::Identity(), place + Vec3d(15.0 * std::max(0.0, time_s - 0.5), 0.0, 0.0)};
    };
    LidarOptions options;
    options.num_threads = 1;
    options.remove_seen_through = is_removed;
    LidarOdometry odometry(options);
    const Motion motion = straight(6.0);
    for (int k = 0; k < 16; ++k) {
      const synthetic::Sweep sweep =
          synthetic::scan(world, small_lidar(), motion, static_cast<unsigned>(k), k * kSweep_s);
      odometry.add(k * kSweep_s, sweep.cloud, shares_from_times(sweep.times_s));
      if (k == 4) {
        EXPECT_GT(num_in_box(odometry, motion(0.5 * kSweep_s), place, size), 10u);
      }
    }
    num_left[is_removed] = num_in_box(odometry, motion(0.5 * kSweep_s), place, size);
  }
  EXPECT_LT(10 * num_left[1], 8 * num_left[0]) << num_left[1] << " " << num_left[0];
}

}  // namespace
}  // namespace augicp
