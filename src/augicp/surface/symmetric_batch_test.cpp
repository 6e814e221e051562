// SPDX-License-Identifier: MIT
#include "augicp/surface/symmetric_batch.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "augicp/surface/shape.h"
#include "augicp/testing/poses.h"

namespace augicp {
namespace {

using testing::random_motion;
using testing::uniform;

Mat3d with_eigenvalues(std::mt19937& generator, const Vec3d& values) {
  const Mat3d rotation = random_motion(generator, 3.0, 0.0).rotation.toRotationMatrix();
  return rotation * values.asDiagonal() * rotation.transpose();
}

// Without the vectors in the middle.
std::vector<Eigen3> solve(const std::vector<Mat3d>& matrices) {
  std::vector<Eigen3> solved;
  for (std::size_t begin = 0; begin < matrices.size(); begin += kBatch) {
    SymmetricBatch batch{};
    const std::size_t count = std::min<std::size_t>(kBatch, matrices.size() - begin);
    for (std::size_t k = 0; k < count; ++k) {
      const Eigen::Matrix3f m = matrices[begin + k].cast<float>();
      batch.xx[k] = m(0, 0), batch.xy[k] = m(0, 1), batch.xz[k] = m(0, 2);
      batch.yy[k] = m(1, 1), batch.yz[k] = m(1, 2), batch.zz[k] = m(2, 2);
    }
    EigenvalueBatch values;
    VectorBatch first, last;
    eigenvalues(batch, values);
    eigenvectors(batch, values.l0, first);
    eigenvectors(batch, values.l2, last);
    for (std::size_t k = 0; k < count; ++k) {
      Eigen3 eigen;
      eigen.values = Eigen::Vector3f(values.l0[k], values.l1[k], values.l2[k]).cast<double>();
      eigen.vectors.col(0) = Eigen::Vector3f(first.x[k], first.y[k], first.z[k]).cast<double>();
      eigen.vectors.col(2) = Eigen::Vector3f(last.x[k], last.y[k], last.z[k]).cast<double>();
      solved.push_back(eigen);
    }
  }
  return solved;
}

// Sine of the angle between two lines.
double apart(const Vec3d& a, const Vec3d& b) { return a.cross(b).norm(); }

// Shapes of neighbourhoods and what is between them, in sizes from a millimetre to a kilometre.
std::vector<Vec3d> spectra(std::mt19937& generator) {
  std::vector<Vec3d> all;
  for (const double size : {1e-6, 1e-3, 1.0, 1e6}) {
    for (const double thin : {0.0, 1e-9, 1e-6, 1e-4, 1e-2, 0.1, 0.5, 1.0})
      for (const double wide : {1e-4, 1e-2, 0.1, 0.3, 0.9, 0.9999, 1.0})
        all.push_back(size * Vec3d(thin * wide, wide, 1.0));
    for (int k = 0; k < 200; ++k) {
      Vec3d values(uniform(generator, 0, 1), uniform(generator, 0, 1), uniform(generator, 0, 1));
      std::sort(values.data(), values.data() + 3);
      all.push_back(size * values);
    }
  }
  return all;
}

TEST(SymmetricBatch, AgreesWithTheIterativeSolver) {
  std::mt19937 generator(1);
  std::vector<Mat3d> matrices;
  for (const Vec3d& values : spectra(generator))
    for (int turn = 0; turn < 5; ++turn) matrices.push_back(with_eigenvalues(generator, values));
  const std::vector<Eigen3> found = solve(matrices);
  for (std::size_t i = 0; i < matrices.size(); ++i) {
    const Eigen3 expected = eigen_of_symmetric(matrices[i]);
    const Vec3d l = expected.values / expected.values.sum();
    EXPECT_LT((found[i].values - expected.values).norm(), 1e-3 * expected.values.sum()) << l.transpose();
    // The accuracy of a vector in float depends on the distance of its eigenvalue from the next.
    const double gap_below = l[1] - l[0], gap_above = l[2] - l[1];
    if (gap_below > 1e-3) {
      EXPECT_NEAR(found[i].values[0] / expected.values.sum(), l[0], 2e-6 + 2e-8 / gap_below) << l.transpose();
      EXPECT_LT(apart(found[i].vectors.col(0), expected.vectors.col(0)), 5e-6 / gap_below) << l.transpose();
      EXPECT_NEAR(found[i].vectors.col(0).norm(), 1.0, 1e-6);
    }
    if (gap_above > 1e-3) {
      EXPECT_LT(apart(found[i].vectors.col(2), expected.vectors.col(2)), 5e-6 / gap_above) << l.transpose();
    }
  }
}

TEST(SymmetricBatch, VectorsAreUnitOrZero) {
  std::mt19937 generator(2);
  std::vector<Mat3d> matrices{Mat3d::Zero(), Mat3d::Identity(), 1e-40 * Mat3d::Identity()};
  for (const Vec3d& values : {Vec3d(0, 0, 1), Vec3d(0, 1e-7, 1), Vec3d(0, 0, 1e-30), Vec3d(1e-6, 1e-6, 1)})
    for (int turn = 0; turn < 20; ++turn) matrices.push_back(with_eigenvalues(generator, values));
  for (const Eigen3& eigen : solve(matrices))
    for (const int which : {0, 2}) {
      const double norm = eigen.vectors.col(which).norm();
      EXPECT_TRUE(norm == 0.0 || std::abs(norm - 1.0) < 1e-6) << norm;
    }
}

TEST(SymmetricBatch, EigenvaluesAscendAndAreNotNegative) {
  std::mt19937 generator(3);
  std::vector<Mat3d> matrices;
  for (const Vec3d& values : spectra(generator)) matrices.push_back(with_eigenvalues(generator, values));
  for (const Eigen3& eigen : solve(matrices)) {
    EXPECT_GE(eigen.values[0], 0.0);
    EXPECT_GE(eigen.values[1], eigen.values[0] * (1.0 - 1e-6));
    EXPECT_GE(eigen.values[2], eigen.values[1] * (1.0 - 1e-6));
  }
}

}  // namespace
}  // namespace augicp
