// SPDX-License-Identifier: MIT
#include "augicp/eval/association.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>
#include <vector>

#include "augicp/testing/poses.h"

namespace augicp {
namespace {

using ::testing::ElementsAre;
using ::testing::Pair;
using Indices = std::vector<std::pair<std::size_t, std::size_t>>;

Trajectory at(const std::vector<double>& stamps_s) {
  Trajectory trajectory;
  for (const double stamp_s : stamps_s) trajectory.push_back({stamp_s, {}});
  return trajectory;
}

Indices pairs(const std::vector<double>& estimate, const std::vector<double>& truth,
              const AssociationOptions& options = {}) {
  Indices indices;
  for (const StampPair& pair : associate(at(estimate), at(truth), options))
    indices.emplace_back(pair.estimate, pair.truth);
  return indices;
}

// The definition, the slow way: all pairs, the closest first.
Indices slow_pairs(const std::vector<double>& estimate, const std::vector<double>& truth, double max_difference_s) {
  std::vector<std::pair<double, std::pair<std::size_t, std::size_t>>> all;
  for (std::size_t i = 0; i < estimate.size(); ++i)
    for (std::size_t j = 0; j < truth.size(); ++j)
      if (std::abs(estimate[i] - truth[j]) <= max_difference_s)
        all.push_back({std::abs(estimate[i] - truth[j]), {i, j}});
  std::sort(all.begin(), all.end());
  std::vector<bool> estimate_taken(estimate.size()), truth_taken(truth.size());
  Indices taken;
  for (const auto& [difference_s, pair] : all) {
    if (estimate_taken[pair.first] || truth_taken[pair.second]) continue;
    estimate_taken[pair.first] = truth_taken[pair.second] = true;
    taken.push_back(pair);
  }
  std::sort(taken.begin(), taken.end());
  return taken;
}

std::vector<double> random_stamps(std::mt19937& generator, int count, double duration_s) {
  std::vector<double> stamps_s(static_cast<std::size_t>(count));
  for (double& stamp_s : stamps_s) stamp_s = testing::uniform(generator, 0.0, duration_s);
  std::sort(stamps_s.begin(), stamps_s.end());
  stamps_s.erase(std::unique(stamps_s.begin(), stamps_s.end()), stamps_s.end());
  return stamps_s;
}

TEST(Association, TakesTheNearestStamp) {
  EXPECT_THAT(pairs({0.0, 1.0, 2.0}, {-0.01, 0.004, 0.99, 1.5, 2.012}),
              ElementsAre(Pair(0, 1), Pair(1, 2), Pair(2, 4)));
}

TEST(Association, IsOneToOne) {
  EXPECT_THAT(pairs({1.0, 1.01}, {1.012}), ElementsAre(Pair(1, 0)));
  EXPECT_THAT(pairs({1.012}, {1.0, 1.01}), ElementsAre(Pair(0, 1)));
  // A pose that lost its nearest takes the second nearest, here across the pair that took it.
  EXPECT_THAT(pairs({1.0, 1.01}, {1.012, 1.015}), ElementsAre(Pair(0, 1), Pair(1, 0)));
}

TEST(Association, ADifferenceOfTheMaximumStillCounts) {
  EXPECT_THAT(pairs({1.0}, {1.5}, {.max_difference_s = 0.5}), ElementsAre(Pair(0, 0)));
  EXPECT_TRUE(pairs({1.0}, {1.5}, {.max_difference_s = std::nextafter(0.5, 0.0)}).empty());
  EXPECT_THAT(pairs({1.0, 2.0}, {2.0, 3.0}, {.max_difference_s = 0.0}), ElementsAre(Pair(1, 0)));
}

TEST(Association, OffsetIsAddedToTheEstimate) {
  EXPECT_THAT(pairs({1.0, 2.0}, {11.0, 12.0}, {.time_offset_s = 10.0}), ElementsAre(Pair(0, 0), Pair(1, 1)));
  EXPECT_TRUE(pairs({1.0, 2.0}, {11.0, 12.0}, {.time_offset_s = -10.0}).empty());
}

TEST(Association, OfNothingIsNothing) {
  EXPECT_TRUE(pairs({}, {}).empty());
  EXPECT_TRUE(pairs({1.0}, {}).empty());
  EXPECT_TRUE(pairs({}, {1.0}).empty());
}

TEST(Association, AgreesWithTheSlowWay) {
  std::mt19937 generator(6);
  for (int trial = 0; trial < 300; ++trial) {
    const auto estimate = random_stamps(generator, 1 + trial % 40, 2.0),
               truth = random_stamps(generator, 1 + trial % 57, 2.0);
    for (const double max_difference_s : {0.001, 0.02, 0.2, 10.0})
      EXPECT_EQ(pairs(estimate, truth, {.max_difference_s = max_difference_s}),
                slow_pairs(estimate, truth, max_difference_s));
  }
}

TEST(Association, AgreesWithTheSlowWayWhereMuchIsEquallyNear) {
  const std::vector<double> whole = {0, 1, 2, 3, 4, 5, 8, 9}, half = {0.5, 1.5, 2.5, 3.5, 7.5, 8.5, 9.5};
  for (const auto& [estimate, truth] : {std::pair(whole, half), std::pair(half, whole), std::pair(whole, whole)})
    for (const double max_difference_s : {0.5, 1.5, 100.0})
      EXPECT_EQ(pairs(estimate, truth, {.max_difference_s = max_difference_s}),
                slow_pairs(estimate, truth, max_difference_s));
}

TEST(Association, IsFastForAnyTolerance) {
  std::vector<double> estimate, truth;
  for (int i = 0; i < 200000; ++i) {
    estimate.push_back(i);
    truth.push_back(i + 0.25);
  }
  EXPECT_EQ(pairs(estimate, truth, {.max_difference_s = 1e9}).size(), estimate.size());  // 4e10 pairs the slow way
}

TEST(Association, OptionsOutOfRangeAreRefused) {
  const double nan = std::numeric_limits<double>::quiet_NaN(), inf = std::numeric_limits<double>::infinity();
  for (const double value : {-0.01, nan, inf})
    EXPECT_THROW(pairs({}, {}, {.max_difference_s = value}), std::invalid_argument) << value;
  for (const double value : {nan, inf})
    EXPECT_THROW(pairs({}, {}, {.time_offset_s = value}), std::invalid_argument) << value;
}

}  // namespace
}  // namespace augicp
