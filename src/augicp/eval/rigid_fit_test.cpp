// SPDX-License-Identifier: MIT
#include "augicp/eval/rigid_fit.h"

#include <gtest/gtest.h>

#include <limits>
#include <numbers>
#include <stdexcept>
#include <vector>

#include "augicp/geometry/rotation.h"
#include "augicp/testing/matchers.h"
#include "augicp/testing/poses.h"

namespace augicp {
namespace {

using testing::NearPose;
using Points = std::vector<Vec3d>;

Points random_points(std::mt19937& generator, int count = 30) {
  Points points;
  for (int i = 0; i < count; ++i)
    points.push_back(testing::uniform(generator, 0.5, 3.0) * testing::random_direction(generator));
  return points;
}

Points moved(const Similarity3& b_from_a, const Points& points_in_a) {
  Points points_in_b;
  for (const Vec3d& x_in_a : points_in_a) points_in_b.push_back(b_from_a * x_in_a);
  return points_in_b;
}

double sum_of_squares(const Similarity3& target_from_source, const Points& source, const Points& target) {
  double sum = 0.0;
  for (std::size_t i = 0; i < source.size(); ++i) sum += (target[i] - target_from_source * source[i]).squaredNorm();
  return sum;
}

TEST(RigidFit, RecoversTheMotion) {
  std::mt19937 generator(1);
  const Points source = random_points(generator);
  for (const Rigid3& target_from_source : testing::awkward_poses()) {
    const RigidFit fit = fit_rigid(source, moved({1.0, target_from_source}, source));
    EXPECT_THAT(fit.target_from_source.motion, NearPose(target_from_source, 1e-11, 1e-11));
    EXPECT_EQ(fit.target_from_source.scale, 1.0);
    EXPECT_TRUE(fit.unique);
  }
}

TEST(RigidFit, RecoversTheScale) {
  std::mt19937 generator(2);
  const Points source = random_points(generator);
  for (const double scale : {1e-3, 0.5, 1.0, 40.0}) {
    const Similarity3 truth{scale, testing::random_motion(generator, 2.0, 5.0)};
    const RigidFit fit = fit_similarity(source, moved(truth, source));
    EXPECT_NEAR(fit.target_from_source.scale / scale, 1.0, 1e-13);
    EXPECT_THAT(fit.target_from_source.motion, NearPose(truth.motion, 1e-12, 1e-11));
  }
}

TEST(RigidFit, ThreePointsAreEnough) {
  const Points source = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  const Rigid3 truth{rotation_exp({0.3, -2.0, 1.0}), {1, 2, 3}};
  const RigidFit fit = fit_rigid(source, moved({1.0, truth}, source));
  EXPECT_THAT(fit.target_from_source.motion, NearPose(truth, 1e-14, 1e-14));
  EXPECT_TRUE(fit.unique);
}

// The definition itself: no small change of any parameter gives a smaller sum.
void expect_least(const Similarity3& fit, const Points& source, const Points& target, bool scale_too) {
  const double least = sum_of_squares(fit, source, target);
  for (const double step : {-1e-4, 1e-4}) {
    for (int k = 0; k < 6; ++k) {
      const Similarity3 beside{fit.scale, retract(fit.motion, step * Vec6d::Unit(k))};
      EXPECT_GT(sum_of_squares(beside, source, target), least);
    }
    if (!scale_too) continue;
    EXPECT_GT(sum_of_squares({fit.scale + step, fit.motion}, source, target), least);
  }
}

TEST(RigidFit, IsTheLeastSumOfSquares) {
  std::mt19937 generator(3);
  for (const Vec3d& signs : {Vec3d(2, 2, 2), Vec3d(-2, 3, 4)}) {  // the second is a mirror
    const Points source = random_points(generator);
    Points target = random_points(generator);
    for (std::size_t i = 0; i < target.size(); ++i) target[i] += signs.cwiseProduct(source[i]);
    const Similarity3 rigid = fit_rigid(source, target).target_from_source;
    const Similarity3 scaled = fit_similarity(source, target).target_from_source;
    expect_least(rigid, source, target, false);
    expect_least(scaled, source, target, true);
    EXPECT_LT(sum_of_squares(scaled, source, target), sum_of_squares(rigid, source, target));
  }
}

TEST(RigidFit, IsNeverAReflection) {
  std::mt19937 generator(4);
  const Points source = random_points(generator);
  for (const Vec3d& signs : {Vec3d(-1, 1, 1), Vec3d(1, -1, 1), Vec3d(1, 1, -1), Vec3d(-1, -1, -1)}) {
    Points mirrored;
    for (const Vec3d& point : source) mirrored.push_back(signs.cwiseProduct(point));
    const Similarity3 fit = fit_rigid(source, mirrored).target_from_source;
    EXPECT_NEAR(fit.motion.rotation.toRotationMatrix().determinant(), 1.0, 1e-14);
    for (int trial = 0; trial < 100; ++trial)  // and the best of the rotations
      EXPECT_GE(
          sum_of_squares({1.0,
                          {testing::random_motion(generator, 3.0 * trial / 100, 0.0).rotation * fit.motion.rotation,
                           fit.motion.translation}},
                         source, mirrored),
          sum_of_squares(fit, source, mirrored) * (1.0 - 1e-12));
  }
}

TEST(RigidFit, OfPointsOnALineDoesNotTurnAboutIt) {
  const Points source = {{1, 1, 1}, {2, 1, 1}, {4, 1, 1}};
  const Rigid3 quarter_turn{rotation_exp({0.0, 0.0, std::numbers::pi / 2}), {5, 6, 7}};
  const Rigid3 with_roll = quarter_turn * Rigid3{rotation_exp({1.0, 0.0, 0.0}), Vec3d::Zero()};
  const Points target = moved({1.0, with_roll}, source);
  const RigidFit fit = fit_rigid(source, target);
  EXPECT_FALSE(fit.unique);
  EXPECT_LE(angle_between(fit.target_from_source.motion, quarter_turn), 1e-14);
  EXPECT_LE(sum_of_squares(fit.target_from_source, source, target), 1e-24);
}

TEST(RigidFit, OfAReversedLineIsHalfATurn) {
  const Points source = {{1, 0, 0}, {2, 0, 0}, {4, 0, 0}}, target = {{-1, 0, 0}, {-2, 0, 0}, {-4, 0, 0}};
  const RigidFit fit = fit_rigid(source, target);
  EXPECT_FALSE(fit.unique);
  EXPECT_NEAR(angle_between(fit.target_from_source.motion, {}), std::numbers::pi, 1e-14);
  EXPECT_LE(sum_of_squares(fit.target_from_source, source, target), 1e-24);
}

TEST(RigidFit, OfEqualPointsIsAStep) {
  for (const std::size_t count : {1u, 2u, 5u}) {
    const Points source(count, Vec3d(1, 2, 3)), target(count, Vec3d(4, 4, 4));
    for (const RigidFit& fit : {fit_rigid(source, target), fit_similarity(source, target)}) {
      EXPECT_FALSE(fit.unique);
      EXPECT_EQ(fit.target_from_source.scale, 1.0);
      EXPECT_THAT(fit.target_from_source.motion,
                  NearPose(Rigid3{Eigen::Quaterniond::Identity(), {3, 2, 1}}, 0.0, 1e-15));
    }
  }
}

TEST(RigidFit, ToOnePointShrinksToIt) {
  const Points source = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, target(3, Vec3d(4, 5, 6));
  const RigidFit fit = fit_similarity(source, target);
  EXPECT_EQ(fit.target_from_source.scale, 0.0);
  EXPECT_LE(sum_of_squares(fit.target_from_source, source, target), 1e-30);
}

TEST(RigidFit, SurvivesFarCoordinates) {
  std::mt19937 generator(5);
  const Points source = random_points(generator);
  const Rigid3 truth{rotation_exp({0.1, 0.2, 0.3}), {1e7, -1e7, 1e6}};
  const RigidFit fit = fit_rigid(source, moved({1.0, truth}, source));
  EXPECT_THAT(fit.target_from_source.motion, NearPose(truth, 1e-8, 1e-6));
}

TEST(RigidFit, ScaledPoseIsTurnedAndItsPlaceScaled) {
  const Similarity3 b_from_a{2.0, {rotation_exp({0.0, 0.0, std::numbers::pi / 2}), {1, 0, 0}}};
  const Rigid3 b_from_body = b_from_a * Rigid3{rotation_exp({0.0, 0.0, 0.5}), {3, 0, 0}};
  EXPECT_THAT(b_from_body,
              NearPose(Rigid3{rotation_exp({0.0, 0.0, std::numbers::pi / 2 + 0.5}), {1, 6, 0}}, 1e-14, 1e-14));
}

TEST(RigidFit, WhatCannotBeFittedIsRefused) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const Points three = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  EXPECT_THROW(fit_rigid({}, {}), std::invalid_argument);
  EXPECT_THROW(fit_rigid(three, Points(2, Vec3d::Zero())), std::invalid_argument);
  EXPECT_THROW(fit_rigid(three, Points{{0, 0, 0}, {1, nan, 0}, {0, 1, 0}}), std::invalid_argument);
  EXPECT_THROW(fit_similarity(Points{{0, 0, 0}, {1e200, 0, 0}, {0, 1, 0}}, three), std::invalid_argument);
}

// A camera that stands still, but for the rounding of its file, has no direction to fit and no scale.
TEST(RigidFit, OfAStillSetIsNotUnique) {
  std::mt19937 generator(21);
  const Points target = random_points(generator, 100);
  for (const double rounding : {0.0, 1e-15, 1e-7, 1e-3}) {
    Points source;
    for (std::size_t i = 0; i < target.size(); ++i)
      source.push_back(Vec3d(1, 2, 3) + rounding * testing::random_direction(generator));
    EXPECT_FALSE(fit_rigid(source, target).unique) << rounding;
    EXPECT_FALSE(fit_similarity(source, target).unique) << rounding;
  }
}

// A straight way with jitter: the turn about it is as good as any where the jitters have nothing in common.
TEST(RigidFit, OfAJitteringLineIsUniqueOnlyWhereTheJitterAgrees) {
  std::mt19937 generator(22);
  Points line, other, same;
  for (int i = 0; i < 100; ++i) {
    const Vec3d place(0.1 * i, 0.0, 0.0);
    line.push_back(place + 0.02 * testing::random_direction(generator));
    other.push_back(place + 0.02 * testing::random_direction(generator));
    same.push_back(line.back() + 0.002 * testing::random_direction(generator));
  }
  EXPECT_FALSE(fit_rigid(line, other).unique);
  EXPECT_TRUE(fit_rigid(line, same).unique);
  EXPECT_TRUE(fit_similarity(line, same).unique);
}

}  // namespace
}  // namespace augicp
