// SPDX-License-Identifier: MIT
#include "augicp/odometry/skew_trial.h"

#include <gtest/gtest.h>

#include <cmath>

#include "augicp/geometry/rotation.h"
#include "augicp/odometry/lidar_testing.h"
#include "augicp/synthetic/lidar.h"
#include "augicp/synthetic/outdoor_scenes.h"
#include "augicp/testing/scenes.h"

namespace augicp {
namespace {

using testing::kSweep_s;

constexpr double kSkewVoxel = 0.7;

synthetic::Lidar lidar() {
  synthetic::Lidar lidar;
  lidar.num_rings = 32;
  lidar.num_azimuths = 720;
  lidar.sweep_s = kSweep_s;
  return lidar;
}

// 8 m/s on an arc.
synthetic::Motion driving(const testing::Scene& scene) {
  return [&scene](double time_s) {
    constexpr double kRate = 0.3, kRadius = 8.0 / kRate;
    const double angle = kRate * time_s;
    return scene.world_from_camera *
           Rigid3{rotation_exp({0.0, 0.0, angle}), {kRadius * std::sin(angle), kRadius * (1.0 - std::cos(angle)), 0.0}};
  };
}

enum class Kind { Measured, AtOnce, Deskewed };

// The scan whose sweep begins at a time.
SkewedScan scan_of(const testing::Scene& scene, Kind kind, double begin_s, unsigned seed) {
  const synthetic::Motion motion = driving(scene);
  const double middle_s = begin_s + 0.5 * kSweep_s;
  const synthetic::Motion moves = kind == Kind::AtOnce ? synthetic::standing_at(motion(middle_s)) : motion;
  const synthetic::Sweep sweep = synthetic::scan({scene, {}}, lidar(), moves, seed, begin_s);
  const SweepShares shares = shares_from_times(sweep.times_s);
  const StampedPose before{middle_s - kSweep_s, motion(middle_s - kSweep_s)}, now{middle_s, motion(middle_s)};
  const SweepMotion during = motion_of_last(std::nullopt, before, now, kSweep_s);
  const Cloud cloud = kind == Kind::Deskewed ? without_skew(sweep.cloud, shares, during, 1) : sweep.cloud;
  return skewed_scan(cloud, shares, during, now.world_from_camera, kSkewVoxel);
}

std::optional<SkewEstimate> estimate(unsigned seed, Kind kind, int num_threads = 1) {
  const testing::Scene scene = synthetic::street(seed);
  return estimate_skew(scan_of(scene, kind, 0.0, seed), scan_of(scene, kind, 0.5, seed + 1), kSkewVoxel, num_threads);
}

TEST(SkewTrial, FindsWhichShareOfTheSkewScansHave) {
  for (const unsigned seed : {11u, 12u})
    for (const auto& [kind, share] : {std::pair{Kind::Measured, 1.0}, {Kind::AtOnce, 0.0}, {Kind::Deskewed, 0.0}}) {
      const auto found = estimate(seed, kind);
      ASSERT_TRUE(found);
      EXPECT_NEAR(found->share, share, 0.15) << "seed " << seed;
      EXPECT_LT(found->deviation, 0.04);
    }
}

TEST(SkewTrial, HasNoAnswerWithoutPairs) {
  const testing::Scene scene = synthetic::street(11);
  const SkewedScan scan = scan_of(scene, Kind::Measured, 0.0, 1);
  SkewedScan elsewhere = scan;
  elsewhere.world_from_sensor.translation.z() += 500.0;
  EXPECT_FALSE(estimate_skew(scan, elsewhere, kSkewVoxel, 1));
  EXPECT_FALSE(estimate_skew(scan, {}, kSkewVoxel, 1));
  EXPECT_FALSE(estimate_skew({}, scan, kSkewVoxel, 1));
}

TEST(SkewTrial, IsTheSameOnAnyNumberOfThreads) {
  const auto one = estimate(11, Kind::Measured, 1), three = estimate(11, Kind::Measured, 3);
  ASSERT_TRUE(one && three);
  EXPECT_EQ(one->share, three->share);
  EXPECT_EQ(one->deviation, three->deviation);
}

TEST(SkewVotes, TimesAreBelievedUntilThreeEstimatesMoreAreAgainstThem) {
  SkewVotes votes;
  for (const double share : {0.1, 0.0, 0.9, -1.0}) {
    votes.add(SkewEstimate{share, 0.01});
    EXPECT_TRUE(votes.is_skewed());
  }
  votes.add(SkewEstimate{0.4, 0.01});
  EXPECT_FALSE(votes.is_skewed());
  EXPECT_FALSE(votes.is_decided());
  for (const double share : {0.9, 1.1, 1.0}) votes.add(SkewEstimate{share, 0.01});
  EXPECT_TRUE(votes.is_skewed());
  EXPECT_TRUE(votes.is_decided());
}

// The map then holds no scan that was bent.
TEST(SkewVotes, AClearEstimateAgainstThemIsBelievedWhereAChangeIsFree) {
  SkewVotes votes;
  votes.add(SkewEstimate{0.4, 0.01}, true);
  EXPECT_TRUE(votes.is_skewed()) << "not clear";
  votes.add(SkewEstimate{0.1, 0.5}, true);
  EXPECT_TRUE(votes.is_skewed()) << "uncertain";
  votes.add(SkewEstimate{0.1, 0.01}, true);
  EXPECT_FALSE(votes.is_skewed());
  for (const double share : {0.9, 1.0}) votes.add(SkewEstimate{share, 0.01});
  EXPECT_FALSE(votes.is_skewed()) << "as many for them as against them";
  votes.add(SkewEstimate{1.0, 0.01});
  EXPECT_TRUE(votes.is_skewed());
}

TEST(SkewVotes, UncertainEstimatesDoNotCount) {
  SkewVotes votes;
  for (int k = 0; k < 10; ++k) votes.add(SkewEstimate{0.0, 0.5});
  votes.add(std::nullopt);
  votes.add(SkewEstimate{0.0, std::nan("")});
  EXPECT_TRUE(votes.is_skewed());
  EXPECT_FALSE(votes.is_decided());
  for (int k = 0; k < 30; ++k) votes.add(std::nullopt);
  EXPECT_TRUE(votes.is_decided());
}

}  // namespace
}  // namespace augicp
