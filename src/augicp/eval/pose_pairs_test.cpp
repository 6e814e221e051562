// SPDX-License-Identifier: MIT
#include "augicp/eval/pose_pairs.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numeric>
#include <stdexcept>
#include <utility>
#include <vector>

#include "augicp/testing/poses.h"

namespace augicp {
namespace {

using ::testing::ElementsAre;
using ::testing::Pair;
using Indices = std::vector<std::pair<std::size_t, std::size_t>>;

// Poses at these times and, in truth, at these places along x; the estimate's path is ten times as long.
std::vector<MatchedPose> poses_at(const std::vector<double>& stamps_s, const std::vector<double>& places) {
  std::vector<MatchedPose> poses;
  for (std::size_t i = 0; i < stamps_s.size(); ++i)
    poses.push_back({stamps_s[i],
                     {Eigen::Quaterniond::Identity(), {10.0 * places[i], 0, 0}},
                     {Eigen::Quaterniond::Identity(), {places[i], 0, 0}}});
  return poses;
}

std::vector<MatchedPose> frames(int count) {
  std::vector<double> numbers(static_cast<std::size_t>(count));
  std::iota(numbers.begin(), numbers.end(), 0.0);
  return poses_at(numbers, numbers);
}

Indices pairs_of_poses(const std::vector<MatchedPose>& poses, const DeltaOptions& options) {
  Indices indices;
  for (const PosePair& pair : pairs_at_delta(poses, options)) indices.emplace_back(pair.first, pair.second);
  return indices;
}

TEST(PosePairs, FramesFromEveryPose) {
  EXPECT_THAT(pairs_of_poses(frames(4), {}), ElementsAre(Pair(0, 1), Pair(1, 2), Pair(2, 3)));
  EXPECT_THAT(pairs_of_poses(frames(5), {.delta = 3}), ElementsAre(Pair(0, 3), Pair(1, 4)));
  EXPECT_EQ(pairs_of_poses(frames(100), {.delta = 20}).size(), 80u);  // none is let in by a tolerance at the end
  EXPECT_TRUE(pairs_of_poses(frames(3), {.delta = 3}).empty());
  EXPECT_TRUE(pairs_of_poses(frames(3), {.delta = 1e300}).empty());
}

TEST(PosePairs, FramesOneAfterTheOther) {
  EXPECT_THAT(pairs_of_poses(frames(8), {.delta = 3, .consecutive = true}), ElementsAre(Pair(0, 3), Pair(3, 6)));
  EXPECT_TRUE(pairs_of_poses(frames(3), {.delta = 3, .consecutive = true}).empty());
}

TEST(PosePairs, SecondsGoToTheNearestStampWithinATenth) {
  const auto poses = poses_at({0.0, 0.5, 0.96, 1.02, 1.6, 3.0}, {0, 0, 0, 0, 0, 0});
  const DeltaOptions second{.delta = 1.0, .unit = DeltaUnit::Seconds};
  // 0.5 -> 1.6 is a tenth too far; from 0.96 on there is nothing near.
  EXPECT_THAT(pairs_of_poses(poses, second), ElementsAre(Pair(0, 3)));
  const DeltaOptions shorter{.delta = 0.55, .unit = DeltaUnit::Seconds};
  EXPECT_THAT(pairs_of_poses(poses, shorter), ElementsAre(Pair(0, 1), Pair(1, 3), Pair(3, 4)));
}

TEST(PosePairs, OfTwoEquallyNearTheEarlierIsTaken) {
  const auto poses = poses_at({0.0, 0.9375, 1.0625}, {0, 0, 0});
  EXPECT_THAT(pairs_of_poses(poses, {.delta = 1.0, .unit = DeltaUnit::Seconds}), ElementsAre(Pair(0, 1)));
}

TEST(PosePairs, SecondsOneAfterTheOtherAreAtLeastDelta) {
  const auto poses = poses_at({0.0, 0.9, 1.1, 2.0, 2.2, 5.0}, {0, 0, 0, 0, 0, 0});
  EXPECT_THAT(pairs_of_poses(poses, {.delta = 1.0, .unit = DeltaUnit::Seconds, .consecutive = true}),
              ElementsAre(Pair(0, 2), Pair(2, 4), Pair(4, 5)));
}

TEST(PosePairs, MetresAreThoseOfTheTruePathThereAndBack) {
  const auto poses = poses_at({0, 1, 2, 3, 4}, {0.0, 0.5, 1.0, 0.5, 0.0});
  EXPECT_THAT(pairs_of_poses(poses, {.delta = 1.0, .unit = DeltaUnit::Metres}),
              ElementsAre(Pair(0, 2), Pair(1, 3), Pair(2, 4)));
  EXPECT_THAT(pairs_of_poses(poses, {.delta = 1.0, .unit = DeltaUnit::Metres, .consecutive = true}),
              ElementsAre(Pair(0, 2), Pair(2, 4)));
}

TEST(PosePairs, OfACameraThatStandsStillTheEarlierPoseIsTaken) {
  const auto poses = poses_at({0, 1, 2, 3, 4, 5}, {0.0, 0.96, 0.96, 0.96, 1.08, 1.08});
  EXPECT_THAT(pairs_of_poses(poses, {.delta = 1.0, .unit = DeltaUnit::Metres}), ElementsAre(Pair(0, 1)));
  EXPECT_TRUE(pairs_of_poses(poses_at({0, 1, 2}, {1, 1, 1}), {.delta = 1.0, .unit = DeltaUnit::Metres}).empty());
}

// The definition, the slow way.
Indices slow_pairs(const std::vector<MatchedPose>& poses, double delta) {
  Indices indices;
  for (std::size_t i = 0; i < poses.size(); ++i) {
    std::size_t nearest = i;
    double least = std::numeric_limits<double>::infinity(), path = 0.0;
    for (std::size_t j = i + 1; j < poses.size(); ++j) {
      path += (poses[j].truth.translation - poses[j - 1].truth.translation).norm();
      if (std::abs(path - delta) >= least) continue;
      least = std::abs(path - delta);
      nearest = j;
    }
    if (nearest > i && least <= 0.1 * delta) indices.emplace_back(i, nearest);
  }
  return indices;
}

TEST(PosePairs, AgreeWithTheSlowWay) {
  std::mt19937 generator(8);
  for (int trial = 0; trial < 200; ++trial) {
    std::vector<double> stamps_s, places{0.0};
    for (int i = 0; i < 60; ++i) stamps_s.push_back(i);
    while (places.size() < stamps_s.size()) places.push_back(places.back() + testing::uniform(generator, -0.3, 0.5));
    const auto poses = poses_at(stamps_s, places);
    for (const double delta : {0.1, 1.0, 3.0})
      EXPECT_EQ(pairs_of_poses(poses, {.delta = delta, .unit = DeltaUnit::Metres}), slow_pairs(poses, delta));
  }
}

TEST(PosePairs, OfFewPosesAreNone) {
  for (const DeltaUnit unit : {DeltaUnit::Frames, DeltaUnit::Seconds, DeltaUnit::Metres})
    for (const bool consecutive : {false, true})
      for (const int count : {0, 1}) EXPECT_TRUE(pairs_of_poses(frames(count), {1.0, unit, consecutive}).empty());
}

TEST(PosePairs, DeltasOutOfRangeAreRefused) {
  const double nan = std::numeric_limits<double>::quiet_NaN(), inf = std::numeric_limits<double>::infinity();
  for (const double delta : {0.0, -1.0, nan, inf})
    EXPECT_THROW(pairs_of_poses({}, {.delta = delta, .unit = DeltaUnit::Seconds}), std::invalid_argument) << delta;
  EXPECT_THROW(pairs_of_poses({}, {.delta = 1.5}), std::invalid_argument);
}

}  // namespace
}  // namespace augicp
