// SPDX-License-Identifier: MIT
#include "augicp/testing/numeric_derivative.h"

#include <gtest/gtest.h>

#include "augicp/geometry/rotation.h"
#include "augicp/testing/poses.h"

namespace augicp::testing {
namespace {

// For a moved point: the identity for the translation, minus the cross matrix for the rotation.
TEST(NumericDerivative, OfAMovedPointIsTheKnownOne) {
  std::mt19937 generator(1);
  const Vec3d point(0.3, -0.7, 1.1);
  for (int i = 0; i < 20; ++i) {
    const Rigid3 pose = random_motion(generator, 1.0, 1.0);
    Eigen::Matrix<double, 3, 6> expected;
    expected << Mat3d::Identity(), -cross_matrix(pose * point);
    const auto numeric = numeric_jacobian<3>([&](const Rigid3& moved) { return Vec3d(moved * point); }, pose);
    EXPECT_LE((numeric - expected).cwiseAbs().maxCoeff(), 1e-9);
  }
}

TEST(NumericDerivative, GradientOfASquaredDistance) {
  const Rigid3 pose{Eigen::Quaterniond::Identity(), Vec3d(1.0, 2.0, 3.0)};
  const Vec6d numeric = numeric_gradient([](const Rigid3& moved) { return moved.translation.squaredNorm(); }, pose);
  Vec6d expected;
  expected << 2.0, 4.0, 6.0, 0.0, 0.0, 0.0;  // turning about the origin keeps the distance
  EXPECT_LE((numeric - expected).cwiseAbs().maxCoeff(), 1e-8);
}

}  // namespace
}  // namespace augicp::testing
