// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "augicp/cloud/cloud.h"
#include "augicp/search/cell_grid.h"
#include "augicp/surface/neighbourhood.h"

namespace augicp {

struct BallOptions {
  double radius = 0.0;  // metres, above 0

  // A ball with fewer points than this grows until it has them, up to max_radius: scans of spinning sensors become
  // sparse with distance.
  std::size_t min_points = 0;
  double max_radius = 0.0;  // metres; below radius: the ball never grows
};

// The most points that all balls of a cloud may contain together: 512 a point, and at least 2^24.
std::size_t max_neighbours(std::size_t num_points);

// Section 4.1 for any cloud: the points in a fixed ball. Memory is bounded: throws std::invalid_argument if the balls
// contain more points than max_neighbours().
class BallNeighbourhood : public Neighbourhood {
 public:
  BallNeighbourhood(const Cloud& cloud, const BallOptions& options, int num_threads);

  // The same with a grid of the cloud that exists already. REQUIRES: its distance is the radius.
  BallNeighbourhood(const Cloud& cloud, const CellGrid& grid, const BallOptions& options, int num_threads);
  Channels sum(const Channels& values, int num_threads) const override;

 private:
  struct List {  // for some points: the number of neighbours of each, and the neighbours of all
    std::vector<std::pair<std::uint32_t, std::size_t>> points;
    std::vector<std::uint32_t> neighbours;
  };
  using Lists = std::vector<List>;

  void find_in_balls(const Cloud& cloud, const CellGrid& grid, const BallOptions& options, int num_threads);
  void widen_poor_balls(const Cloud& cloud, const BallOptions& options, int num_threads);
  void append(Lists lists);
  template <int kRows>
  void sum_rows(const Channels& values, std::size_t begin, std::size_t end, Channels& sums) const;

  std::span<const std::uint32_t> neighbours_of(std::size_t point) const;

  struct Range {
    std::size_t begin = 0;
    std::uint32_t count = 0, list = 0;
  };
  std::vector<Range> of_point_;  // where each point's neighbours are in a list of neighbours_
  std::vector<std::vector<std::uint32_t>> neighbours_;
};

}  // namespace augicp
