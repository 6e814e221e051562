// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "augicp/cloud/cloud.h"

namespace augicp {

// The points of a cloud by the cubes of a regular grid in which they lie. Where every point asks for all within one distance, those
// of a cell share what is around it, which takes a fraction of the time that as many descents of a tree do. Const calls may run
// concurrently.
class CellGrid {
 public:
  // distance: metres, above 0. Points nearer to each other than this lie in one cell or in two that touch.
  CellGrid(const Cloud& cloud, double distance);

  // Cells that hold points.
  std::size_t num_cells() const { return cells_.size(); }

  // Its points, in ascending order.
  std::span<const std::uint32_t> points_of(std::size_t cell) const;

  // Fills `points` with those of a cell and of all that touch it, in ascending order. An out-argument, so that a loop over
  // many cells reuses one buffer.
  void around(std::size_t cell, std::vector<std::uint32_t>& points) const;

 private:
  using Place = std::array<std::int64_t, 3>;
  struct Cell {
    Place place;
    std::size_t begin;  // of its points
  };

  // Of the cells from one place up to another above it.
  std::span<const std::uint32_t> points_in_column(const Place& first, std::int64_t last_z) const;

  std::vector<Cell> cells_;  // by their places
  std::vector<std::uint32_t> points_;
};

}  // namespace augicp
