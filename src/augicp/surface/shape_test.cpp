// SPDX-License-Identifier: MIT
#include "augicp/surface/shape.h"

#include <gtest/gtest.h>

#include "augicp/testing/poses.h"

namespace augicp {
namespace {

// Accuracy of the closed form, relative to the largest eigenvalue.
constexpr double kDigits = 1e-8;

Eigen3 eigen_with(double l0, double l1, double l2) {
  return eigen_of_symmetric(Vec3d(l0, l1, l2).asDiagonal().toDenseMatrix());
}

Gaussian gaussian_of(double count) {
  Gaussian points;
  points.count = count;
  return points;
}

struct ShapeCase {
  const char* name;
  Vec3d eigenvalues;
  Structure paper, first_step;
};

// Section 4.1, and what ours makes of the same numbers before it looks at normals.
TEST(Shape, ClassesOfKnownEigenvalues) {
  for (const ShapeCase& c : {ShapeCase{"plane", {0.0, 0.25, 0.25}, Structure::Planar, Structure::Planar},
                             ShapeCase{"half a plane", {0.0, 0.07, 0.25}, Structure::Planar, Structure::Planar},
                             ShapeCase{"crease", {0.035, 0.125, 0.25}, Structure::Edge, Structure::Planar},
                             ShapeCase{"wire", {0.001, 0.002, 0.25}, Structure::Edge, Structure::Edge},
                             ShapeCase{"corner", {0.1, 0.11, 0.12}, Structure::None, Structure::None},
                             ShapeCase{"one place", {0.0, 0.0, 0.0}, Structure::None, Structure::None}}) {
    const Eigen3 eigen = eigen_with(c.eigenvalues[0], c.eigenvalues[1], c.eigenvalues[2]);
    EXPECT_EQ(shape_of_points(gaussian_of(100), eigen, {}).structure, c.paper) << c.name;
    EXPECT_EQ(line_or_normal(gaussian_of(100), eigen, Vec3d::Zero(), {}).structure, c.first_step) << c.name;
  }
}

TEST(Shape, TooFewPointsSayNothing) {
  const ShapeThresholds thresholds;
  const Eigen3 plane = eigen_with(0.0, 0.25, 0.25);
  const Gaussian few = gaussian_of(thresholds.min_points - 1.0);
  EXPECT_EQ(shape_of_points(few, plane, thresholds).structure, Structure::None);
  EXPECT_EQ(line_or_normal(few, plane, Vec3d::Zero(), thresholds).structure, Structure::None);
}

TEST(Shape, LineAlongTheLineOfSightIsNoWire) {
  const Eigen3 line = eigen_with(0.0001, 0.002, 0.25);
  EXPECT_EQ(line_or_normal(gaussian_of(100), line, Vec3d::UnitX(), {}).structure, Structure::Edge);
  EXPECT_EQ(line_or_normal(gaussian_of(100), line, Vec3d::UnitZ(), {}).structure, Structure::Planar);
}

TEST(Shape, SpreadOfTwoAndOfThreeNormals) {
  const Mat3d x = Vec3d::UnitX() * Vec3d::UnitX().transpose(), y = Vec3d::UnitY() * Vec3d::UnitY().transpose();
  const Mat3d z = Vec3d::UnitZ() * Vec3d::UnitZ().transpose();
  EXPECT_NEAR(spread_of_normals(eigen_of_symmetric(x)).across, 0.0, kDigits);
  const NormalSpread crease = spread_of_normals(eigen_of_symmetric(0.75 * x + 0.25 * y));
  EXPECT_NEAR(crease.across, 0.25, kDigits);
  EXPECT_NEAR(crease.along, 0.0, kDigits);
  EXPECT_NEAR(std::abs(crease.tangent.z()), 1.0, kDigits);
  EXPECT_NEAR(spread_of_normals(eigen_of_symmetric(0.5 * x + 0.3 * y + 0.2 * z)).along, 0.2, kDigits);
}

TEST(Shape, EigenvectorsRebuildTheMatrix) {
  std::mt19937 generator(5);
  for (int trial = 0; trial < 50; ++trial) {
    const Vec3d a = testing::random_direction(generator), b = testing::random_direction(generator);
    const Mat3d matrix = a * a.transpose() + 0.3 * b * b.transpose();
    const Eigen3 eigen = eigen_of_symmetric(matrix);
    EXPECT_LT((eigen.vectors * eigen.values.asDiagonal() * eigen.vectors.transpose() - matrix).norm(), kDigits);
    EXPECT_LE(eigen.values[0], eigen.values[1]);
    EXPECT_LE(eigen.values[1], eigen.values[2]);
    EXPECT_GE(eigen.values[0], 0.0);
  }
}

}  // namespace
}  // namespace augicp
