// SPDX-License-Identifier: MIT
#pragma once

#include <span>

#include "augicp/cloud/posed_pairs.h"

namespace augicp {

// The typical size of one kind of error: its median, so that a wrong pair in four does not show. 0 where there is none.
struct ResidualStatistics {
  std::int64_t count = 0;
  double median = 0.0;  // metres, or radians
};

// What a pose leaves of each measured quantity, over pairs of points.
struct Residuals {
  ResidualStatistics point;    // distance of planar target points' partners from their planes, metres
  ResidualStatistics normal;   // angle between two normals, radians
  ResidualStatistics tangent;  // angle between two tangents, radians
};

// Points without their origins. Normals compare with their sign where both sensors' places are known.
Residuals residuals(const PosedPairs& posed);

}  // namespace augicp
