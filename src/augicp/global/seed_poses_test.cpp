// SPDX-License-Identifier: MIT
#include "augicp/global/seed_poses.h"

#include <gmock/gmock.h>

#include "augicp/global/key_testing.h"
#include "augicp/testing/matchers.h"

namespace augicp {
namespace {

using testing::NearPose;

constexpr SeedOptions kOptions{0.1, 0.7, 0.1, 0.1, 0.1, 20};

std::vector<SeedPose> found_in(const KnownKeys& keys, int num_threads) {
  const ConsistencyGraph graph(keys.source, keys.target, keys.pairs, {0.05, 0.2, 0.3}, num_threads);
  return seed_poses(keys.source, keys.target, keys.pairs, graph, kOptions, num_threads);
}

TEST(FittedPose, IsExactForTruePairs) {
  for (unsigned seed = 1; seed <= 10; ++seed) {
    const KnownKeys keys = known_keys(20, 0, seed);
    EXPECT_THAT(fitted_pose(keys.source, keys.target, keys.pairs, 0.1), NearPose(keys.target_from_source, 1e-5, 1e-5));
  }
}

// Two extended points fix a pose, where two points leave a rotation free.
TEST(FittedPose, OfTwoExtendedPointsIsExact) {
  for (unsigned seed = 1; seed <= 10; ++seed) {
    const KnownKeys keys = known_keys(2, 0, seed);
    EXPECT_THAT(fitted_pose(keys.source, keys.target, keys.pairs, 0.5), NearPose(keys.target_from_source, 1e-4, 1e-4));
  }
}

TEST(FittedPose, IsNeverAReflection) {
  KnownKeys keys = known_keys(20, 0, 1);
  for (Vec3f& point : keys.target.points) point.z() = -point.z();
  for (Vec3f& normal : keys.target.normals) normal.z() = -normal.z();
  const Rigid3 pose = fitted_pose(keys.source, keys.target, keys.pairs, 0.1);
  EXPECT_NEAR(pose.rotation.toRotationMatrix().determinant(), 1.0, 1e-9);
}

TEST(SeedPoses, TheTrueOneIsFirstAmongNineFalsePairsOfTen) {
  for (unsigned seed = 1; seed <= 10; ++seed) {
    const auto poses = found_in(known_keys(40, 400, seed), 1);
    ASSERT_FALSE(poses.empty()) << seed;
    EXPECT_THAT(poses.front().target_from_source, NearPose(known_keys(40, 400, seed).target_from_source, 0.01, 0.01));
    EXPECT_GE(poses.front().support, 40.0);
  }
}

TEST(SeedPoses, AreDistinctAndBestFirst) {
  const auto poses = found_in(known_keys(30, 700, 3), 1);
  ASSERT_GT(poses.size(), 1u);
  for (std::size_t k = 1; k < poses.size(); ++k) EXPECT_GE(poses[k - 1].support, poses[k].support);
  EXPECT_LE(poses.size(), kOptions.max_count);
}

TEST(SeedPoses, SameBitsOnAnyNumberOfThreads) {
  const KnownKeys keys = known_keys(30, 700, 3);
  const auto alone = found_in(keys, 1);
  for (const int num_threads : {2, 8}) {
    const auto poses = found_in(keys, num_threads);
    ASSERT_EQ(poses.size(), alone.size());
    for (std::size_t k = 0; k < poses.size(); ++k)
      EXPECT_EQ(poses[k].target_from_source.matrix(), alone[k].target_from_source.matrix());
  }
}

TEST(SeedPoses, OfTooFewPairsAreNone) {
  EXPECT_TRUE(found_in(known_keys(0, 0, 1), 1).empty());
  EXPECT_TRUE(found_in(known_keys(2, 0, 1), 1).empty());
}

}  // namespace
}  // namespace augicp
