// SPDX-License-Identifier: MIT
#include "augicp/geometry/rotation.h"

#include <gtest/gtest.h>

#include <numbers>
#include <unsupported/Eigen/MatrixFunctions>

#include "augicp/testing/matchers.h"
#include "augicp/testing/poses.h"

namespace augicp {
namespace {

using testing::NearVector;
using testing::random_direction;

const double kAngles[] = {0.0, 1e-300, 1e-16, 1e-9, 9.9e-5, 1.1e-4, 2.1e-4, 0.5, 2.0, std::numbers::pi - 1e-9};

TEST(Rotation, ExpAgreesWithTheMatrixExponential) {
  std::mt19937 generator(1);
  for (double angle : kAngles) {
    const Vec3d rotation_vector = angle * random_direction(generator);
    const Mat3d expected = cross_matrix(rotation_vector).exp();
    EXPECT_LE((rotation_exp(rotation_vector).toRotationMatrix() - expected).cwiseAbs().maxCoeff(), 1e-14) << angle;
  }
}

TEST(Rotation, LogUndoesExp) {
  std::mt19937 generator(2);
  for (double angle : kAngles) {
    const Vec3d rotation_vector = angle * random_direction(generator);
    EXPECT_THAT(rotation_log(rotation_exp(rotation_vector)), NearVector(rotation_vector, 1e-14 + 1e-15 * angle));
  }
}

TEST(Rotation, LogIsTheShortestWay) {
  const Vec3d long_way(0.0, 0.0, 1.5 * std::numbers::pi);
  EXPECT_THAT(rotation_log(rotation_exp(long_way)), NearVector(Vec3d(0.0, 0.0, -0.5 * std::numbers::pi), 1e-14));
}

TEST(Rotation, BothQuaternionsOfARotationHaveTheSameLog) {
  const Eigen::Quaterniond q = rotation_exp(Vec3d(0.3, -0.2, 0.9));
  EXPECT_THAT(rotation_log(Eigen::Quaterniond(-q.coeffs())), NearVector(rotation_log(q), 1e-15));
}

TEST(Rotation, CrossMatrixIsTheCrossProduct) {
  const Vec3d a(1.0, 2.0, 3.0), b(-4.0, 0.5, 7.0);
  EXPECT_THAT(cross_matrix(a) * b, NearVector(a.cross(b), 1e-14));
}

}  // namespace
}  // namespace augicp
