// SPDX-License-Identifier: MIT
#include "augicp/eval/pair_errors.h"

#include <gtest/gtest.h>

#include "augicp/geometry/rotation.h"

namespace augicp {
namespace {

// A pose each 1.02 m along x.
std::vector<Rigid3> path(std::size_t count) {
  std::vector<Rigid3> poses(count);
  for (std::size_t i = 0; i < count; ++i) poses[i].translation.x() = 1.02 * static_cast<double>(i);
  return poses;
}

ReferencePair forward(std::size_t first, std::size_t second, double turn_rad = 0.0) {
  return {first, second, {rotation_exp({0.0, 0.0, turn_rad}), {static_cast<double>(second - first), 0.0, 0.0}}};
}

TEST(PairErrors, CompareMotionsAndSkipPairsBeyondTheEnd) {
  const std::vector<ReferencePair> pairs{forward(0, 10, 0.01), forward(5, 80)};
  const std::vector<PairError> errors = pair_errors(path(60), pairs);
  ASSERT_EQ(errors.size(), 1u);
  EXPECT_NEAR(errors[0].translation, 0.2, 1e-12);
  EXPECT_NEAR(errors[0].rotation, 0.01, 1e-12);
  EXPECT_NEAR(errors[0].bias, 0.2, 1e-12);
}

TEST(PairErrors, DoNotDependOnTheWorld) {
  const Rigid3 other{rotation_exp({0.3, -1.0, 0.2}), {5.0, 6.0, 7.0}};
  std::vector<Rigid3> moved = path(20);
  for (Rigid3& pose : moved) pose = other * pose;
  const std::vector<ReferencePair> pairs{forward(3, 15, 0.02)};
  EXPECT_NEAR(pair_errors(moved, pairs)[0].translation, pair_errors(path(20), pairs)[0].translation, 1e-12);
}

TEST(GapErrors, AreMeansOverPairsOfOneGap) {
  const std::vector<ReferencePair> pairs{forward(0, 20, 0.04), forward(0, 10, 0.01), forward(20, 30, 0.03)};
  const std::vector<GapError> errors = errors_by_gap(pair_errors(path(60), pairs));
  ASSERT_EQ(errors.size(), 2u);
  EXPECT_EQ(errors[0].gap, 10u);
  EXPECT_EQ(errors[0].num_pairs, 2u);
  EXPECT_NEAR(errors[0].length, 10.0, 1e-12);
  EXPECT_NEAR(errors[0].translation, 0.2, 1e-12);
  EXPECT_NEAR(errors[0].bias, 0.2, 1e-12);
  EXPECT_NEAR(errors[0].rotation, 0.02, 1e-12);
  EXPECT_EQ(errors[1].gap, 20u);
  EXPECT_NEAR(errors[1].rotation, 0.04, 1e-12);
  EXPECT_TRUE(errors_by_gap({}).empty());
}

}  // namespace
}  // namespace augicp
