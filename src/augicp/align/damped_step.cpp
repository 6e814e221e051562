// SPDX-License-Identifier: MIT
#include "augicp/align/damped_step.h"

#include <Eigen/Cholesky>

namespace augicp {

namespace {

Mat6d damped(const Mat6d& H, double damping) {
  Mat6d sum = H;
  sum.diagonal().head<3>().array() += damping * H.diagonal().head<3>().mean();
  sum.diagonal().tail<3>().array() += damping * H.diagonal().tail<3>().mean();
  return sum;
}

}  // namespace

Vec6d damped_step(const NormalEquations& equations, double damping) {
  return damped(equations.H, damping).ldlt().solve(-equations.b);
}

Vec6d held_step(const NormalEquations& equations, double damping, const Observability& observability, int num_free) {
  if (num_free >= 6) return Vec6d::Zero();
  const Eigen::Matrix<double, 6, Eigen::Dynamic> held = observability.directions.rightCols(6 - num_free);
  const Eigen::MatrixXd H = held.transpose() * damped(equations.H, damping) * held;
  const Eigen::VectorXd b = held.transpose() * equations.b;
  return held * H.ldlt().solve(-b);
}

}  // namespace augicp
