// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "augicp/core/types.h"

namespace augicp {

// The quadratic approximation of the objective at a pose, Eq. (14), for the increment of geometry/rigid3.h: translation
// first, rotation vector second, target frame.
struct NormalEquations {
  Mat6d H = Mat6d::Zero();
  Vec6d b = Vec6d::Zero();
  double cost = 0.0;  // half the sum of the robust losses; b is its gradient
  std::int64_t num_pairs = 0;
  std::int64_t num_intensity_pairs = 0;  // pairs whose intensities were compared

  NormalEquations& operator+=(const NormalEquations& other) {
    H += other.H;
    b += other.b;
    cost += other.cost;
    num_pairs += other.num_pairs;
    num_intensity_pairs += other.num_intensity_pairs;
    return *this;
  }
};

}  // namespace augicp
