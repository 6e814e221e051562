// SPDX-License-Identifier: MIT
#include "augicp/shutter/sweep.h"

#include <gtest/gtest.h>

#include <algorithm>
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

// A turn while driving: 15 m/s and 90 degrees a second.
synthetic::Motion fast_motion(const Rigid3& world_from_sensor) {
  return synthetic::moving_evenly(world_from_sensor,
                                  {rotation_exp({0.0, 0.0, 0.5 * std::numbers::pi}), {15.0, 0.0, 0.0}});
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

TEST(Sweep, StraightenedPointsAreThoseOfTheTrueMotion) {
  const synthetic::Lidar lidar = lidar_of(0.0);
  const testing::Scene street = synthetic::street(3);
  const synthetic::Motion motion = fast_motion(street.world_from_camera);
  const synthetic::Sweep sweep = synthetic::scan({street, {}}, lidar, motion, 1);
  const Rigid3 first_from_last = inverse(motion(sweep.times_s.front())) * motion(sweep.times_s.back());
  const double middle_s = 0.5 * (sweep.times_s.front() + sweep.times_s.back());
  const Cloud expected = synthetic::straightened(sweep, motion, 0.0, middle_s);
  const Cloud straight = without_skew(sweep.cloud, shares_from_times(sweep.times_s), first_from_last, 1);
  double largest_skew = 0.0;
  for (std::size_t i = 0; i < straight.size(); ++i) {
    EXPECT_LT((straight.points[i] - expected.points[i]).norm(), 0.01f);
    largest_skew = std::max(largest_skew, static_cast<double>((sweep.cloud.points[i] - expected.points[i]).norm()));
  }
  EXPECT_GT(largest_skew, 1.0);
}

TEST(Sweep, WithoutSharesPointsStayAndOddSharesAreRefused) {
  Cloud cloud;
  cloud.points = {{1.0f, 2.0f, 3.0f}};
  const Rigid3 motion{rotation_exp({0.1, 0.0, 0.0}), {1.0, 0.0, 0.0}};
  EXPECT_EQ(without_skew(cloud, {}, motion, 1).points, cloud.points);
  EXPECT_THROW(without_skew(cloud, {0.0f, 1.0f}, motion, 1), std::invalid_argument);
}

}  // namespace
}  // namespace augicp
