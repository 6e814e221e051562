// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "augicp/cloud/cloud.h"

namespace augicp {

// The points of a cloud by the cubes of a regular grid in which they lie. Where every point asks for all within one
// distance, those of a cell share what is around it, which takes a fraction of the time that as many descents of a tree
// do. Const calls may run concurrently.
class CellGrid {
 public:
  // distance: metres, above 0. Points nearer to each other than this lie in one cell or in two that touch.
  CellGrid(const Cloud& cloud, double distance);

  // Cells that hold points.
  std::size_t num_cells() const { return cells_.size(); }

  // Its points, in ascending order.
  std::span<const std::uint32_t> points_of(std::size_t cell) const;

  class Walk;

 private:
  using Place = std::array<std::int64_t, 3>;
  struct Cell {
    Place place;
    std::size_t begin;  // of its points
  };

  // The first cell from one on that does not lie below a place; num_cells() where all do.
  std::size_t seek(std::size_t from, const Place& place) const;

  // Of the cells from one on up to a place.
  std::span<const std::uint32_t> points_up_to(std::size_t first, const Place& last) const;

  std::vector<Cell> cells_;  // by their places
  std::vector<std::uint32_t> points_;
};

// From cell to cell in ascending order: what touches the next cell lies not far behind what touched the last.
class CellGrid::Walk {
 public:
  // The grid must outlive it.
  Walk(const CellGrid& grid, std::size_t first_cell) : grid_(grid), cell_(first_cell) {}

  // Fills `points` with those of the next cell and of all that touch it, each once, in an order that depends on the
  // cloud only. An out-argument, so that all cells share one buffer.
  void next(std::vector<std::uint32_t>& points);

 private:
  const CellGrid& grid_;
  std::size_t cell_;
  std::array<std::size_t, 9> columns_{};  // where those that touched the last cell begin
};

}  // namespace augicp
