// SPDX-License-Identifier: MIT
#include "benchmarks/peers/common/pose.h"

#include <stdexcept>

namespace augicp::peers {

std::optional<Rigid3> rigid_or_nothing(const Mat4d& matrix) {
  try {
    return rigid3_from_matrix(matrix);
  } catch (const std::invalid_argument&) {
    return std::nullopt;
  }
}

}  // namespace augicp::peers
