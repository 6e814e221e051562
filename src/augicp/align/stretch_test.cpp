// SPDX-License-Identifier: MIT
#include "augicp/align/stretch.h"

#include <gtest/gtest.h>

#include <cmath>

namespace augicp {
namespace {

AlignOptions with_stretch(double max_stretch) {
  AlignOptions options;
  options.max_stretch = max_stretch;
  return options;
}

Vec6d along(double length) { return length * Vec6d(1.0, 0.0, 2.0, -1.0, 0.0, 0.5); }

// How many steps a loop takes until the error is a thousandth, where each increment is a share of the error.
int steps_until_small(double share, double max_stretch) {
  const AlignOptions options = with_stretch(max_stretch);
  Stretch stretch(options);
  double error = 1.0;
  int steps = 0;
  for (; std::abs(error) > 1e-3; ++steps)
    error -= stretch.of(along(share * error)).norm() / along(1.0).norm() * (error > 0.0 ? 1.0 : -1.0);
  return steps;
}

TEST(Stretch, EqualStepsAreDoubledUpToTheLimit) {
  const AlignOptions options = with_stretch(8.0);
  Stretch stretch(options);
  for (const double factor : {1.0, 2.0, 4.0, 8.0, 8.0})
    EXPECT_TRUE(stretch.of(along(1e-3)).isApprox(along(factor * 1e-3))) << factor;
}

TEST(Stretch, StepsThatTurnAreTakenAsTheyAre) {
  const AlignOptions options = with_stretch(16.0);
  Stretch stretch(options);
  for (int k = 0; k < 3; ++k) stretch.of(along(1e-3));
  EXPECT_TRUE(stretch.of(along(-1e-3)).isApprox(along(-1e-3)));
  const Vec6d across = 1e-3 * Vec6d(0.0, 1.0, 0.0, 0.0, 0.0, 0.0);
  EXPECT_TRUE(stretch.of(across).isApprox(across));
}

TEST(Stretch, WhereStepsShrinkTheFactorIsHalved) {
  const AlignOptions options = with_stretch(16.0);
  Stretch stretch(options);
  for (int k = 0; k < 3; ++k) stretch.of(along(1e-3));
  EXPECT_TRUE(stretch.of(along(5e-4)).isApprox(along(2.0 * 5e-4)));
  EXPECT_TRUE(stretch.of(along(2e-4)).isApprox(along(2e-4)));
  EXPECT_TRUE(stretch.of(along(1e-4)).isApprox(along(1e-4)));
}

TEST(Stretch, NothingIsLengthenedWithoutIt) {
  const AlignOptions options = with_stretch(1.0);
  Stretch stretch(options);
  for (int k = 0; k < 4; ++k) EXPECT_TRUE(stretch.of(along(1e-3)).isApprox(along(1e-3)));
}

TEST(Stretch, ZeroStepsStayZero) {
  const AlignOptions options = with_stretch(16.0);
  Stretch stretch(options);
  for (int k = 0; k < 3; ++k) EXPECT_TRUE(stretch.of(Vec6d::Zero()).isZero());
}

TEST(Stretch, ALoopThatCreepsEndsSoonerAndOneThatDoesNotIsNoSlower) {
  EXPECT_LT(steps_until_small(0.01, 16.0), steps_until_small(0.01, 1.0) / 4);
  for (const double share : {0.05, 0.2, 0.35, 0.9})
    EXPECT_LE(steps_until_small(share, 16.0), steps_until_small(share, 1.0)) << share;
}

}  // namespace
}  // namespace augicp
