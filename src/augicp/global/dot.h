// SPDX-License-Identifier: MIT
// The scalar product of vectors whose coordinates are columns. Internal.
#pragma once

#include "augicp/core/vectorized.h"

namespace augicp {

// As Eigen adds them up.
AUGICP_INLINE float dot(float ax, float ay, float az, float bx, float by, float bz) {
  return ax * bx + (ay * by + az * bz);
}

}  // namespace augicp
