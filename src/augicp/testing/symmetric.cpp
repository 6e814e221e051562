// SPDX-License-Identifier: MIT
#include "augicp/testing/symmetric.h"

#include <Eigen/Eigenvalues>

namespace augicp::testing {

Vec6d eigenvalues_of(const Mat6d& symmetric) {
  return Eigen::SelfAdjointEigenSolver<Mat6d>(symmetric, Eigen::EigenvaluesOnly).eigenvalues();
}

Mat6d sqrt_of(const Mat6d& symmetric) {
  const Eigen::SelfAdjointEigenSolver<Mat6d> eigen(symmetric);
  return eigen.eigenvectors() * eigen.eigenvalues().cwiseMax(0.0).cwiseSqrt().asDiagonal() *
         eigen.eigenvectors().transpose();
}

}  // namespace augicp::testing
