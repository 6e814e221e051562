// SPDX-License-Identifier: MIT
// Derivatives by central differences, as a reference for the analytic ones.
#pragma once

#include "augicp/geometry/rigid3.h"

namespace augicp::testing {

// d f(retract(pose, increment)) / d increment at zero, of a function from poses to vectors of Rows numbers. The default
// step balances rounding against curvature for values near 1; the error is then about 1e-9.
template <int Rows, typename Function>
Eigen::Matrix<double, Rows, 6> numeric_jacobian(const Function& function, const Rigid3& pose, double step = 1e-5) {
  Eigen::Matrix<double, Rows, 6> jacobian;
  for (int i = 0; i < 6; ++i) {
    const Vec6d increment = step * Vec6d::Unit(i);
    const Eigen::Matrix<double, Rows, 1> ahead = function(retract(pose, increment));
    const Eigen::Matrix<double, Rows, 1> behind = function(retract(pose, -increment));
    jacobian.col(i) = (ahead - behind) / (2.0 * step);
  }
  return jacobian;
}

// The same for a function from poses to one number.
template <typename Function>
Vec6d numeric_gradient(const Function& function, const Rigid3& pose, double step = 1e-5) {
  const auto as_vector = [&](const Rigid3& moved) { return Eigen::Matrix<double, 1, 1>(function(moved)); };
  return numeric_jacobian<1>(as_vector, pose, step).transpose();
}

}  // namespace augicp::testing
