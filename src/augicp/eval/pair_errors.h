// SPDX-License-Identifier: MIT
// Errors of an odometry against motions that are known for some pairs of its poses.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "augicp/geometry/trajectory.h"

namespace augicp {

struct PairError {
  ReferencePair pair;
  double translation = 0.0;  // metres, of the difference of the motions
  double rotation = 0.0;     // radians
  double bias = 0.0;         // metres: how much longer the estimated motion is than the known one
};

// The errors of the pairs whose poses exist. estimate: world_from_sensor.
std::vector<PairError> pair_errors(std::span<const Rigid3> estimate, std::span<const ReferencePair> pairs);

// Means over pairs that are equally many poses apart.
struct GapError {
  std::size_t gap = 0;  // second - first
  std::size_t num_pairs = 0;
  double length = 0.0;       // metres, of the known motions
  double translation = 0.0;  // metres
  double rotation = 0.0;     // radians
  double bias = 0.0;         // metres
};

// One entry for each gap, ascending. The mean error divided by the mean length is the error as a share of the path.
std::vector<GapError> errors_by_gap(std::span<const PairError> errors);

}  // namespace augicp
