// SPDX-License-Identifier: MIT
#pragma once

#include <span>

#include "augicp/cloud/posed_pairs.h"

namespace augicp {

// The typical size of one kind of residual: the median, so that a quarter of wrong pairs does not matter. 0 if there is
// none.
struct ResidualStatistics {
  std::int64_t count = 0;
  double median = 0.0;  // metres, or radians
};

// The residuals of each measured quantity under a pose, over pairs of points.
struct Residuals {
  ResidualStatistics point;    // distance of the source point from the target point's plane, metres
  ResidualStatistics normal;   // angle between two normals, radians
  ResidualStatistics tangent;  // angle between two tangents, radians
};

// Points are without their origins. Normals are compared with their sign if both sensor positions are known.
Residuals residuals(const PosedPairs& posed);

}  // namespace augicp
