// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "augicp/search/kd_tree.h"
#include "augicp/surface/neighbourhood.h"

namespace augicp {

struct BallOptions {
  double radius = 0.0;  // metres, above 0

  // Where fewer points than this lie in the ball it grows to hold as many, up to max_radius: scans of spinning sensors
  // thin out with distance.
  std::size_t min_points = 0;
  double max_radius = 0.0;  // metres; below radius: the ball never grows
};

// Section 4.1 for any cloud: the points in a fixed ball, found with a kd-tree. The cloud must outlive it.
// Memory is bounded: throws std::invalid_argument where the balls hold more than 512 points on average, and 2^24 together.
class BallNeighbourhood : public Neighbourhood {
 public:
  BallNeighbourhood(const Cloud& cloud, const BallOptions& options, int num_threads);
  Channels sum(const Channels& values, int num_threads) const override;

 private:
  std::vector<std::size_t> begin_;         // of each point's neighbours; one more than points
  std::vector<std::uint32_t> neighbours_;  // of all points, one after the other
};

}  // namespace augicp
