// SPDX-License-Identifier: MIT
#pragma once

#include <limits>

#include "augicp/cloud/cloud.h"

namespace augicp {

// Which pairs are accepted (section 4.1). Each gate is off by default.
struct Gates {
  // Pairs farther apart than this are dropped, metres.
  double max_distance = std::numeric_limits<double>::infinity();

  // Pairs of planar points are dropped if their normals differ by more, and pairs of edges if their tangents do;
  // radians.
  double max_angle = std::numeric_limits<double>::infinity();

  // Pairs of a planar point and an edge are dropped. If they are kept, only their positions count (Omega^l = 0).
  bool same_structure = false;

  // Throws std::invalid_argument unless distances and angles are above 0.
  void check() const;
};

}  // namespace augicp
