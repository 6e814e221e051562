// SPDX-License-Identifier: MIT
#include "augicp/global/candidate_poses.h"

#include <gmock/gmock.h>

#include "augicp/core/error.h"
#include "augicp/global/key_testing.h"
#include "augicp/testing/matchers.h"

namespace augicp {
namespace {

using testing::NearPose;

struct Pair {
  Cloud source, target;
  Rigid3 target_from_source;  // between the points
};

// The object twice, in any position.
Pair drawn_twice(const synthetic::Object& object, unsigned seed) {
  std::mt19937 generator(seed);
  Pair pair;
  pair.target_from_source = testing::random_motion(generator, testing::uniform(generator, 0.5, 3.1), 2.0);
  pair.target = synthetic::sampled(object, 20000, 0.0005, generator);
  pair.source = transform(synthetic::sampled(object, 20000, 0.0005, generator), inverse(pair.target_from_source));
  pair.target_from_source = without_origins(pair.target_from_source, pair.source, pair.target);
  return pair;
}

CandidateOptions options_for(double voxel_size, int num_threads = 1) {
  CandidateOptions options;
  options.voxel_size = voxel_size;
  options.num_threads = num_threads;
  return options;
}

TEST(CandidatePoses, UniqueObjectsAreFoundFromAnywhere) {
  for (const synthetic::Object& object : synthetic::objects()) {
    if (!object.is_unique) continue;
    const Pair pair = drawn_twice(object, 1);
    const auto poses = candidate_poses(pair.source, pair.target, options_for(0.012));
    ASSERT_FALSE(poses.empty()) << object.name;
    EXPECT_THAT(poses.front().target_from_source, NearPose(pair.target_from_source, 0.1, 0.05)) << object.name;
  }
}

TEST(CandidatePoses, SameBitsOnAnyNumberOfThreads) {
  const Pair pair = drawn_twice(synthetic::objects().front(), 1);
  const auto alone = candidate_poses(pair.source, pair.target, options_for(0.015));
  ASSERT_FALSE(alone.empty());
  for (const int num_threads : {2, 5}) {
    const auto poses = candidate_poses(pair.source, pair.target, options_for(0.015, num_threads));
    ASSERT_EQ(poses.size(), alone.size());
    for (std::size_t k = 0; k < poses.size(); ++k) {
      EXPECT_EQ(poses[k].target_from_source.matrix(), alone[k].target_from_source.matrix());
      EXPECT_EQ(poses[k].support, alone[k].support);
    }
  }
}

TEST(CandidatePoses, OfEmptyAndTinyCloudsAreNone) {
  const Pair pair = drawn_twice(synthetic::objects().front(), 1);
  EXPECT_TRUE(candidate_poses({}, pair.target, options_for(0.02)).empty());
  EXPECT_TRUE(candidate_poses(pair.source, {}, options_for(0.02)).empty());
  Cloud point;
  point.points.push_back(Vec3f::Ones());
  EXPECT_TRUE(candidate_poses(point, pair.target, options_for(0.02)).empty());
}

TEST(CandidatePoses, EndOnRequest) {
  const Pair pair = drawn_twice(synthetic::objects().front(), 1);
  std::stop_source stop;
  stop.request_stop();
  CandidateOptions options = options_for(0.02);
  options.stop = stop.get_token();
  EXPECT_THROW(candidate_poses(pair.source, pair.target, options), Interrupted);
}

TEST(CommonVoxel, BoundsTheNumberOfPoints) {
  const Pair pair = drawn_twice(synthetic::objects().front(), 1);
  const double voxel_size = common_voxel(pair.source, pair.target, 0.004, 1500);
  EXPECT_GT(voxel_size, 0.004);
  EXPECT_LE(key_cloud(pair.target, voxel_size, std::nullopt, 1).size(), 1500u);
  EXPECT_EQ(common_voxel(pair.source, pair.target, 0.05, 1500), 0.05);
}

}  // namespace
}  // namespace augicp
