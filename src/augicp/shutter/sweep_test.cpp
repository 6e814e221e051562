// SPDX-License-Identifier: MIT
#include "augicp/shutter/sweep.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <numeric>
#include <stdexcept>

#include "augicp/cloud/voxel_grid.h"
#include "augicp/geometry/rotation.h"
#include "augicp/synthetic/lidar.h"
#include "augicp/synthetic/outdoor_scenes.h"

namespace augicp {
namespace {

synthetic::Lidar lidar_of(double sigma) {
  synthetic::Lidar lidar;
  lidar.num_rings = 16;
  lidar.num_azimuths = 360;
  lidar.range_sigma = sigma;
  return lidar;
}

// 15 m/s and 90 degrees a second: along a line while rotating, on an arc as vehicles do, and braking from 15 m/s.
constexpr double kSpeed = 15.0, kRate = 0.5 * std::numbers::pi;

synthetic::Motion along_a_line(const Rigid3& world_from_sensor) {
  return synthetic::moving_evenly(world_from_sensor, {rotation_exp({0.0, 0.0, kRate}), {kSpeed, 0.0, 0.0}});
}

synthetic::Motion on_an_arc(const Rigid3& world_from_sensor) {
  return [=](double time_s) {
    const double angle = kRate * time_s, radius = kSpeed / kRate;
    return world_from_sensor *
           Rigid3{rotation_exp({0.0, 0.0, angle}), {radius * std::sin(angle), radius * (1.0 - std::cos(angle)), 0.0}};
  };
}

synthetic::Motion braking(const Rigid3& world_from_sensor) {
  return [=](double time_s) {
    return world_from_sensor *
           Rigid3{Eigen::Quaterniond::Identity(), {kSpeed * time_s - 4.0 * time_s * time_s, 0.0, 0.0}};
  };
}

synthetic::Motion rotating_faster(const Rigid3& world_from_sensor) {
  return [=](double time_s) {
    return world_from_sensor * Rigid3{rotation_exp({0.0, 0.0, 4.0 * time_s * time_s}), Vec3d::Zero()};
  };
}

struct Case {
  synthetic::Motion motion;
  double begin_s;  // of the sweep
  synthetic::Sweep sweep;
};

Case measured(const std::function<synthetic::Motion(const Rigid3&)>& moving, double begin_s) {
  const testing::Scene street = synthetic::street(3);
  const synthetic::Motion motion = moving(street.world_from_camera);
  return {motion, begin_s, synthetic::scan({street, {}}, lidar_of(0.0), motion, 1, begin_s)};
}

double middle_s(const Case& of) { return 0.5 * (of.sweep.times_s.front() + of.sweep.times_s.back()); }

double duration_s(const Case& of) { return of.sweep.times_s.back() - of.sweep.times_s.front(); }

StampedPose true_pose(const Case& of, double gaps_later) {
  const double time_s = of.begin_s + middle_s(of) + 0.1 * gaps_later;
  return {time_s, of.motion(time_s)};
}

// The largest distance between the points that are straightened with a motion and with the true one.
float largest_error(const Case& of, const SweepMotion& motion) {
  const Cloud expected = synthetic::straightened(of.sweep, of.motion, of.begin_s, middle_s(of));
  const Cloud straight = without_skew(of.sweep.cloud, shares_from_times(of.sweep.times_s), motion, 1);
  float largest = 0.0f;
  for (std::size_t i = 0; i < straight.size(); ++i)
    largest = std::max(largest, (straight.points[i] - expected.points[i]).norm());
  return largest;
}

TEST(Sweep, SharesDoNotDependOnTheUnitOrTheZeroOfTimes) {
  const std::vector<double> seconds{0.0, 0.025, 0.1, 0.05};
  std::vector<double> nanoseconds;
  for (const double time : seconds) nanoseconds.push_back(1.6e18 + 1e9 * time);
  const SweepShares expected{0.0f, 0.25f, 1.0f, 0.5f};
  EXPECT_EQ(shares_from_times(seconds), expected);
  const SweepShares shares = shares_from_times(nanoseconds);
  for (std::size_t i = 0; i < expected.size(); ++i) EXPECT_NEAR(shares[i], expected[i], 1e-5f);
}

TEST(Sweep, TimesThatAreAllTheSameGiveNoShares) {
  EXPECT_TRUE(shares_from_times(std::vector<double>{3.0, 3.0}).empty());
  EXPECT_TRUE(shares_from_times({}).empty());
}

TEST(Sweep, TheUnitOfTimesFollowsFromTheSweepsDuration) {
  for (const double expected_s : {0.05, 0.1, 0.5})
    for (const double share : {0.2, 0.99, 4.0})
      for (const double unit_s : {1.0, 1e-3, 1e-6, 1e-9})
        EXPECT_EQ(likely_time_unit_s(share * expected_s / unit_s, expected_s), unit_s);
  EXPECT_FALSE(likely_time_unit_s(1e6, 1.0 / 31.0));
  EXPECT_FALSE(likely_time_unit_s(0.0, 0.1));
}

TEST(Sweep, TimesThatAreNotFiniteAreRefused) {
  EXPECT_THROW(shares_from_times(std::vector<double>{0.0, std::numeric_limits<double>::quiet_NaN()}),
               std::invalid_argument);
}

// Wherever the sweep begins, and to whichever side the sensor turns.
TEST(Sweep, SharesFromTheOrderAreThoseOfTheTimes) {
  const testing::Scene street = synthetic::street(3);
  const synthetic::Sweep sweep =
      synthetic::scan({street, {}}, lidar_of(0.0), synthetic::standing_at(street.world_from_camera), 1);
  const SweepShares expected = shares_from_times(sweep.times_s);
  for (const double begin_rad : {0.0, 1.0, 3.0, -2.0})
    for (const double side : {1.0, -1.0}) {
      Cloud cloud = sweep.cloud;
      for (Vec3f& p : cloud.points) p.y() *= static_cast<float>(side);
      cloud = transform(cloud, {rotation_exp({0.0, 0.0, begin_rad}), Vec3d::Zero()});
      const SweepShares shares = shares_from_order(cloud);
      ASSERT_EQ(shares.size(), expected.size());
      for (std::size_t i = 0; i < shares.size(); ++i) EXPECT_NEAR(shares[i], expected[i], 0.01f);
    }
}

TEST(Sweep, PointsInAnotherOrderHaveNoShares) {
  const testing::Scene street = synthetic::street(3);
  const synthetic::Sweep sweep =
      synthetic::scan({street, {}}, lidar_of(0.0), synthetic::standing_at(street.world_from_camera), 1);
  std::vector<std::uint32_t> ring_by_ring(sweep.cloud.size());
  std::iota(ring_by_ring.begin(), ring_by_ring.end(), 0u);
  std::stable_sort(ring_by_ring.begin(), ring_by_ring.end(),
                   [&](std::uint32_t a, std::uint32_t b) { return sweep.rings[a] < sweep.rings[b]; });
  EXPECT_TRUE(shares_from_order(select(sweep.cloud, ring_by_ring)).empty());
  EXPECT_TRUE(shares_from_order(downsample(sweep.cloud, 0.3)).empty());
  EXPECT_TRUE(shares_from_order({}).empty());
}

TEST(Sweep, AzimuthsGoClockwiseFromBehindTheSensor) {
  Cloud cloud;
  cloud.points = {{-1.0f, 0.01f, 0.0f}, {0.0f, 1.0f, 0.0f}, {1.0f, 0.0f, 0.0f}, {0.0f, -1.0f, 0.0f}};
  const SweepShares shares = shares_from_azimuth(cloud);
  const float expected[] = {0.0f, 0.25f, 0.5f, 0.75f};
  for (std::size_t i = 0; i < shares.size(); ++i) EXPECT_NEAR(shares[i], expected[i], 0.01f);
}

// Parabolas through the poses leave the third order of a motion, a few millimetres of an arc's.
TEST(Sweep, PointsAreStraightenedWithTheMotionThroughThreePoses) {
  for (const auto& moving : {along_a_line, on_an_arc, braking, rotating_faster}) {
    const Case of = measured(moving, 0.3);
    const SweepMotion motion =
        motion_of_last(true_pose(of, -2.0), true_pose(of, -1.0), true_pose(of, 0.0), duration_s(of));
    EXPECT_LT(largest_error(of, motion), 0.015f);
    EXPECT_GT(largest_error(of, {}), 0.3f);
  }
}

TEST(Sweep, PointsStraightenedAgainAreWhereTheOtherMotionAlonePutsThem) {
  const Case of = measured(braking, 0.3);
  const SweepShares shares = shares_from_times(of.sweep.times_s);
  const SweepMotion motion =
      motion_of_last(true_pose(of, -2.0), true_pose(of, -1.0), true_pose(of, 0.0), duration_s(of));
  SweepMotion wrong = motion;
  wrong.velocity += Vec3d(0.1, -0.05, 0.02);
  wrong.rotation += Vec3d(0.0, 0.01, -0.02);
  const Cloud once = without_skew(of.sweep.cloud, shares, motion, 1);
  const Cloud again = straightened_again(without_skew(of.sweep.cloud, shares, wrong, 1), shares, wrong, motion, 1);
  for (std::size_t i = 0; i < once.size(); ++i) EXPECT_LT((again.points[i] - once.points[i]).norm(), 1e-4f);
}

TEST(Sweep, UnevenGapsBetweenPosesGiveTheSameParabola) {
  const Case of = measured(braking, 0.5);
  const SweepMotion motion =
      motion_of_last(true_pose(of, -5.0), true_pose(of, -1.0), true_pose(of, 0.0), duration_s(of));
  EXPECT_LT(largest_error(of, motion), 0.003f);
}

TEST(Sweep, TwoPosesAreOnAnArc) {
  const Case of = measured(on_an_arc, 0.3);
  const SweepMotion motion = motion_of_last(std::nullopt, true_pose(of, -1.0), true_pose(of, 0.0), duration_s(of));
  EXPECT_LT(largest_error(of, motion), 0.006f);
}

TEST(Sweep, TheMotionOfAnEarlierSweepFollowsFromItsAccelerations) {
  for (const auto& moving : {along_a_line, braking, rotating_faster}) {
    const Case of = measured(moving, 0.3);
    const double sweep_s = duration_s(of);
    const SweepMotion later = motion_of_last(true_pose(of, 0.0), true_pose(of, 1.0), true_pose(of, 2.0), sweep_s);
    EXPECT_LT(largest_error(of, later_by(-0.2 / sweep_s, later)), 0.01f);
  }
}

TEST(Sweep, WithoutSharesPointsStayAndOddSharesAreRefused) {
  Cloud cloud;
  cloud.points = {{1.0f, 2.0f, 3.0f}};
  SweepMotion motion;
  motion.velocity = {1.0, 0.0, 0.0};
  EXPECT_EQ(without_skew(cloud, {}, motion, 1).points, cloud.points);
  EXPECT_THROW(without_skew(cloud, {0.0f, 1.0f}, motion, 1), std::invalid_argument);
}

}  // namespace
}  // namespace augicp
