// SPDX-License-Identifier: MIT
#include "augicp/geometry/rigid3.h"

#include <gtest/gtest.h>

#include <limits>
#include <numbers>

#include "augicp/geometry/rotation.h"
#include "augicp/testing/matchers.h"
#include "augicp/testing/poses.h"

namespace augicp {
namespace {

using testing::awkward_poses;
using testing::NearPose;
using testing::NearVector;

TEST(Rigid3, InverseUndoes) {
  for (const Rigid3& b_from_a : awkward_poses()) {
    EXPECT_THAT(inverse(b_from_a) * b_from_a, NearPose(Rigid3{}, 1e-14, 1e-11));
    EXPECT_THAT(b_from_a * inverse(b_from_a), NearPose(Rigid3{}, 1e-14, 1e-11));
  }
}

TEST(Rigid3, ProductMovesPointsOneAfterTheOther) {
  const Vec3d x_in_a(0.3, -2.0, 5.0);
  for (const Rigid3& b_from_a : awkward_poses())
    for (const Rigid3& c_from_b : awkward_poses())
      EXPECT_THAT((c_from_b * b_from_a) * x_in_a, NearVector(c_from_b * (b_from_a * x_in_a), 1e-11));
}

TEST(Rigid3, MatrixMovesPointsAlike) {
  const Vec3d x_in_a(0.3, -2.0, 5.0);
  for (const Rigid3& b_from_a : awkward_poses())
    EXPECT_THAT((b_from_a.matrix() * x_in_a.homogeneous()).head<3>(), NearVector(b_from_a * x_in_a, 1e-11));
}

TEST(Rigid3, MatrixRoundTrip) {
  for (const Rigid3& b_from_a : awkward_poses())
    EXPECT_THAT(rigid3_from_matrix(b_from_a.matrix()), NearPose(b_from_a, 1e-14, 0.0));
}

// The convention itself: a step in x and a quarter turn about z, both in the frame that the pose maps into.
TEST(Rigid3, IncrementIsTranslationThenRotationOnTheLeft) {
  const Rigid3 pose{Eigen::Quaterniond::Identity(), Vec3d(1.0, 0.0, 0.0)};
  Vec6d increment;
  increment << 10.0, 0.0, 0.0, 0.0, 0.0, std::numbers::pi / 2;
  const Rigid3 moved = retract(pose, increment);
  EXPECT_THAT(moved * Vec3d::Zero(), NearVector(Vec3d(10.0, 1.0, 0.0), 1e-14));
  EXPECT_THAT(moved.rotation * Vec3d::UnitX(), NearVector(Vec3d::UnitY(), 1e-14));
}

TEST(Rigid3, IncrementBetweenUndoesRetract) {
  std::mt19937 generator(3);
  for (const Rigid3& pose : awkward_poses()) {
    Vec6d increment;
    increment << testing::random_direction(generator), 0.8 * testing::random_direction(generator);
    EXPECT_LE((increment_between(pose, retract(pose, increment)) - increment).norm(), 1e-11);
  }
}

TEST(Rigid3, AngleBetweenIsTheAngleOfTheStep) {
  for (const Rigid3& pose : awkward_poses()) {
    Vec6d increment;
    increment << 1.0, 2.0, 3.0, 0.3, 0.0, -0.4;
    EXPECT_NEAR(angle_between(pose, retract(pose, increment)), 0.5, 1e-14);
  }
}

TEST(Rigid3, RotationStaysUnitOverLongChains) {
  const Rigid3 step{rotation_exp(Vec3d(0.01, 0.02, 0.03)), Vec3d(1e-3, 0.0, 0.0)};
  Rigid3 pose;
  for (int i = 0; i < 100000; ++i) pose = step * pose;
  EXPECT_NEAR(pose.rotation.norm(), 1.0, 1e-14);
}

// robustness 14: a guess that is not a rigid motion.
TEST(Rigid3, WhatIsNotARigidMotionIsRefused) {
  Mat4d reflection = Mat4d::Identity();
  reflection(0, 0) = -1.0;
  Mat4d scaled = Mat4d::Identity();
  scaled(1, 1) = 1.1;
  Mat4d nan = Mat4d::Identity();
  nan(0, 3) = std::numeric_limits<double>::quiet_NaN();
  Mat4d projective = Mat4d::Identity();
  projective(3, 0) = 0.5;
  for (const Mat4d& matrix : {reflection, scaled, nan, projective, Mat4d(Mat4d::Zero())})
    EXPECT_THROW(rigid3_from_matrix(matrix), std::invalid_argument);
}

TEST(Rigid3, RoundedMatrixBecomesTheNearestRotation) {
  const Rigid3 exact{rotation_exp(Vec3d(0.3, -0.2, 0.9)), Vec3d(1.0, 2.0, 3.0)};
  const Mat4d rounded = (exact.matrix() * 1e4).array().round() / 1e4;
  const Rigid3 read = rigid3_from_matrix(rounded);
  EXPECT_NEAR(read.rotation.norm(), 1.0, 1e-15);
  EXPECT_THAT(read, NearPose(exact, 1e-4, 1e-4));
}

// The matrix of a pose is a rotation up to the last digits, and a power of two in the last row is exact.
TEST(Rigid3, WhatIsWithinTheToleranceIsRead) {
  const Mat4d exact = Rigid3{Eigen::Quaterniond(0.0, 0.0, 1.0, 0.0), Vec3d(1.0, 2.0, 3.0)}.matrix();
  EXPECT_NO_THROW(rigid3_from_matrix(exact, 0.0));
  Mat4d scaled = exact, projective = exact;
  scaled(1, 1) = 1.0 + 0x1p-10;
  projective(3, 1) = 0x1p-10;
  for (const Mat4d& matrix : {scaled, projective}) {
    EXPECT_NO_THROW(rigid3_from_matrix(matrix, 0x1p-8));
    EXPECT_THROW(rigid3_from_matrix(matrix, 0x1p-11), std::invalid_argument);
  }
  EXPECT_NO_THROW(rigid3_from_matrix(projective, 0x1p-10)) << "the tolerance itself is allowed";
}

}  // namespace
}  // namespace augicp
