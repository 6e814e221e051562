// SPDX-License-Identifier: MIT
#include "augicp/surface/eigen_batch.h"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>
#include <random>
#include <vector>

#include "augicp/testing/poses.h"

namespace augicp {
namespace {

using testing::random_motion;
using testing::uniform;

// Of flat, long and round neighbourhoods in sizes from a millimetre to a kilometre, and of all between.
std::vector<Vec3d> spectra(std::mt19937& generator) {
  std::vector<Vec3d> all;
  for (const double size : {1e-6, 1.0, 1e6}) {
    for (const double thin : {0.0, 1e-9, 1e-6, 1e-4, 1e-2, 0.1, 0.5, 0.999, 1.0})
      for (const double wide : {0.0, 1e-4, 1e-2, 0.1, 0.3, 0.9, 0.999, 0.9999, 1.0})
        all.push_back(size * Vec3d(thin * wide, wide, 1.0));
    for (int k = 0; k < 300; ++k) {
      Vec3d values(uniform(generator, 0, 1), uniform(generator, 0, 1), uniform(generator, 0, 1));
      std::sort(values.data(), values.data() + 3);
      all.push_back(size * values);
    }
  }
  return all;
}

std::vector<Mat3d> matrices() {
  std::mt19937 generator(3);
  std::vector<Mat3d> all{Mat3d::Zero(), Mat3d::Identity()};
  for (const Vec3d& values : spectra(generator)) {
    const Mat3d rotation = random_motion(generator, 3.0, 0.0).rotation.toRotationMatrix();
    all.push_back(rotation * values.asDiagonal() * rotation.transpose());
  }
  return all;
}

std::vector<Eigen3> solved_at_once(const std::vector<Mat3d>& matrices, std::size_t batch) {
  std::vector<Eigen3> solved(matrices.size());
  for (std::size_t first = 0; first < matrices.size(); first += batch) {
    const std::size_t count = std::min(batch, matrices.size() - first);
    eigen_of_symmetric(std::span(matrices).subspan(first, count), std::span(solved).subspan(first, count));
  }
  return solved;
}

TEST(EigenBatch, AgreesWithTheIterativeSolver) {
  const std::vector<Mat3d> all = matrices();
  const std::vector<Eigen3> solved = solved_at_once(all, kEigenBatch);
  for (std::size_t i = 0; i < all.size(); ++i) {
    const Eigen::SelfAdjointEigenSolver<Mat3d> expected(all[i]);
    const Vec3d& l = expected.eigenvalues();
    const double size = std::max(l[2], 1e-30);
    EXPECT_LT((solved[i].values - l.cwiseMax(0.0)).norm(), 2e-8 * size) << l.transpose();
    const double gap = std::min(l[1] - l[0], l[2] - l[1]) / size;
    if (gap < 1e-2) continue;
    EXPECT_LT((solved[i].values - l.cwiseMax(0.0)).norm(), 1e-10 * size) << l.transpose();
    for (int k = 0; k < 3; ++k)
      EXPECT_NEAR(std::abs(solved[i].vectors.col(k).dot(expected.eigenvectors().col(k))), 1.0, 1e-9) << l.transpose();
  }
}

// The number of matrices at once changes nothing.
TEST(EigenBatch, EachMatrixIsSolvedAlone) {
  const std::vector<Mat3d> all = matrices();
  const std::vector<Eigen3> together = solved_at_once(all, kEigenBatch), alone = solved_at_once(all, 1);
  for (std::size_t i = 0; i < all.size(); ++i) {
    EXPECT_EQ(together[i].values, alone[i].values);
    EXPECT_EQ(together[i].vectors, alone[i].vectors);
  }
}

TEST(EigenBatch, VectorsAreAnOrthonormalBasis) {
  for (const Eigen3& eigen : solved_at_once(matrices(), kEigenBatch))
    EXPECT_LT((eigen.vectors.transpose() * eigen.vectors - Mat3d::Identity()).norm(), 1e-6);
}

}  // namespace
}  // namespace augicp
