// SPDX-License-Identifier: MIT
#include "augicp/align/damped_step.h"

#include <Eigen/Cholesky>

namespace augicp {

Vec6d damped_step(const NormalEquations& equations, double damping) {
  Mat6d damped = equations.H;
  damped.diagonal().head<3>().array() += damping * equations.H.diagonal().head<3>().mean();
  damped.diagonal().tail<3>().array() += damping * equations.H.diagonal().tail<3>().mean();
  return damped.ldlt().solve(-equations.b);
}

}  // namespace augicp
