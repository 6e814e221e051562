// SPDX-License-Identifier: MIT
// Registration without a guess.
#include <gmock/gmock.h>

#include <algorithm>

#include "augicp/registration/registration.h"
#include "augicp/synthetic/objects.h"
#include "augicp/testing/matchers.h"
#include "augicp/testing/poses.h"
#include "augicp/testing/room_pair.h"

namespace augicp {
namespace {

using testing::NearPose;

struct ObjectPair {
  Cloud source, target;
  Rigid3 target_from_source;
};

ObjectPair object_anywhere(const std::string& name, unsigned seed) {
  const auto all = synthetic::objects();
  const auto object = std::find_if(all.begin(), all.end(), [&](const auto& one) { return one.name == name; });
  std::mt19937 generator(seed);
  ObjectPair pair;
  pair.target_from_source = testing::random_motion(generator, testing::uniform(generator, 1.0, 3.1), 2.0);
  pair.target = synthetic::sampled(*object, 15000, 0.0005, generator);
  pair.source = transform(synthetic::sampled(*object, 15000, 0.0005, generator), inverse(pair.target_from_source));
  return pair;
}

RegistrationOptions without_guess() {
  RegistrationOptions options;
  options.global = true;
  return options;
}

TEST(WithoutGuess, ObjectsMeetFromAnywhere) {
  for (unsigned seed = 1; seed <= 2; ++seed) {
    const ObjectPair pair = object_anywhere("bracket", seed);
    const AlignResult result = register_scans(scan_of(pair.source), scan_of(pair.target), {}, without_guess()).result;
    EXPECT_EQ(result.status, AlignStatus::Converged) << seed;
    EXPECT_THAT(result.target_from_source, NearPose(pair.target_from_source, 0.01, 0.01)) << seed;
  }
}

// The guess leads nowhere, nor does what is tried around it.
TEST(WithoutGuess, IsTriedWhereAGuessConvincesNowhere) {
  for (unsigned seed = 1; seed <= 2; ++seed) {
    const ObjectPair pair = object_anywhere("bracket", seed);
    const AlignResult result = register_scans(scan_of(pair.source), scan_of(pair.target)).result;
    EXPECT_EQ(result.status, AlignStatus::Converged) << seed;
    EXPECT_THAT(result.target_from_source, NearPose(pair.target_from_source, 0.01, 0.01)) << seed;
  }
}

TEST(WithoutGuess, TheGuessIsIgnored) {
  const ObjectPair pair = object_anywhere("bracket", 1);
  std::mt19937 generator(9);
  const Rigid3 guess = testing::random_motion(generator, 2.0, 30.0);
  const auto from = [&](const Rigid3& initial) {
    return register_scans(scan_of(pair.source), scan_of(pair.target), initial, without_guess()).result;
  };
  const AlignResult with_guess = from(guess), without = from({});
  EXPECT_EQ(with_guess.target_from_source.matrix(), without.target_from_source.matrix());
  EXPECT_EQ(with_guess.status, without.status);
}

TEST(WithoutGuess, VotesAreCountedFarFromTheGuessAlone) {
  const ObjectPair pair = object_anywhere("bracket", 1);
  const auto outvoted_from = [&](const Rigid3& initial, const RegistrationOptions& options) {
    return register_scans(scan_of(pair.source), scan_of(pair.target), initial, options).result.evidence->outvoted;
  };
  const double anywhere = outvoted_from({}, without_guess());
  EXPECT_GT(anywhere, 0.0);
  EXPECT_LT(anywhere, 1.0);
  EXPECT_EQ(outvoted_from({}, {}), anywhere);  // found without the guess, which is more than a radian off
  EXPECT_EQ(outvoted_from(pair.target_from_source, {}), 0.0);
}

TEST(WithoutGuess, DepthImagesMeetFromAnywhere) {
  std::mt19937 generator(4);
  const testing::ScanPair pair = testing::room_pair(testing::random_motion(generator, 0.3, 0.3));
  const AlignResult result = register_scans(pair.source, pair.target, {}, without_guess()).result;
  EXPECT_EQ(result.status, AlignStatus::Converged);
  EXPECT_THAT(result.target_from_source, NearPose(pair.target_from_source, 0.01, 0.02));
}

TEST(WithoutGuess, WhatIsNotThereIsNotFound) {
  const Cloud bracket = object_anywhere("bracket", 1).source, mug = object_anywhere("mug", 2).target;
  EXPECT_NE(register_scans(scan_of(bracket), scan_of(mug), {}, without_guess()).result.status, AlignStatus::Converged);
}

TEST(WithoutGuess, ResultsAreTheSameOnAnyNumberOfThreads) {
  const ObjectPair pair = object_anywhere("bracket", 2);
  RegistrationOptions options = without_guess();
  const auto with_threads = [&](int num_threads) {
    options.num_threads = num_threads;
    return find_pose(scan_of(pair.source), scan_of(pair.target), options);
  };
  const auto alone = with_threads(1);
  ASSERT_FALSE(alone.empty());
  for (const int num_threads : {2, 5}) {
    const auto found = with_threads(num_threads);
    ASSERT_EQ(found.size(), alone.size());
    for (std::size_t k = 0; k < found.size(); ++k)
      EXPECT_EQ(found[k].result.target_from_source.matrix(), alone[k].result.target_from_source.matrix());
  }
}

TEST(FindPose, BestFirstWithEvidence) {
  const ObjectPair pair = object_anywhere("bracket", 3);
  const auto found = find_pose(scan_of(pair.source), scan_of(pair.target));
  ASSERT_FALSE(found.empty());
  EXPECT_THAT(found.front().result.target_from_source, NearPose(pair.target_from_source, 0.01, 0.01));
  EXPECT_EQ(found.front().result.status, AlignStatus::Converged);
  for (const FoundPose& one : found) EXPECT_TRUE(one.result.evidence.has_value());
  for (std::size_t k = 1; k < found.size(); ++k)
    EXPECT_GE(strain(*found[k].result.evidence), strain(*found[0].result.evidence));
}

// A stool has three equal legs: each of its poses would converge alone.
TEST(FindPose, OfSeveralPosesThatFitNoneConverges) {
  const ObjectPair pair = object_anywhere("stool", 1);
  const auto found = find_pose(scan_of(pair.source), scan_of(pair.target));
  ASSERT_GE(found.size(), 2u);
  EXPECT_EQ(found.front().result.status, AlignStatus::Ambiguous);
  std::size_t num_ambiguous = 0;
  for (const FoundPose& one : found) {
    EXPECT_NE(one.result.status, AlignStatus::Converged);
    num_ambiguous += one.result.status == AlignStatus::Ambiguous ? 1 : 0;
  }
  EXPECT_GE(num_ambiguous, 2u);
}

TEST(FindPose, OfEmptyAndSinglePointsIsNothing) {
  const Cloud bracket = object_anywhere("bracket", 1).source;
  Cloud point;
  point.points.push_back(Vec3f::Ones());
  EXPECT_TRUE(find_pose(scan_of({}), scan_of(bracket)).empty());
  EXPECT_TRUE(find_pose(scan_of(bracket), scan_of(point)).empty());
  EXPECT_EQ(register_scans(scan_of({}), scan_of(bracket), {}, without_guess()).result.status, AlignStatus::TooFewPairs);
}

TEST(FindPose, ATinyRadiusIsNoError) {
  const ObjectPair pair = object_anywhere("bracket", 1);
  RegistrationOptions options;
  options.radius = 1e-9;
  EXPECT_NO_THROW(find_pose(scan_of(pair.source), scan_of(pair.target), options));
}

TEST(FindPose, ThePapersPresetIsRefused) {
  RegistrationOptions options;
  options.preset = Preset::Paper;
  EXPECT_THROW(find_pose({}, {}, options), std::invalid_argument);
}

TEST(WithoutGuess, ThePaperStartsFromAGuess) {
  RegistrationOptions options;
  options.preset = Preset::Paper;
  EXPECT_NO_THROW(options.check());
  options.global = true;
  EXPECT_THROW(options.check(), std::invalid_argument);
}

}  // namespace
}  // namespace augicp
