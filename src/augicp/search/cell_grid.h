// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "augicp/cloud/cloud.h"

namespace augicp {

// The points of a cloud by the cubes of a regular grid. For queries that ask, for every point, for all points within
// one distance: the points of a cell share the search of the cells around it, which takes a fraction of the time of one
// tree descent per point. Thread safety: const calls may run concurrently.
class CellGrid {
 public:
  // distance: metres, above 0. Points closer than this to each other are in the same cell or in two cells that touch.
  CellGrid(const Cloud& cloud, double distance);

  // Cells with at least one point.
  std::size_t num_cells() const { return cells_.size(); }

  std::size_t num_points() const { return points_.size(); }

  // The cell of a point, by the point's rank in the order of the cells. REQUIRES: rank < num_points().
  std::size_t cell_at(std::size_t rank) const;

  // The points of a cell, in ascending order.
  std::span<const std::uint32_t> points_of(std::size_t cell) const;

  class Walk;

 private:
  using Place = std::array<std::int64_t, 3>;
  struct Cell {
    Place place;
    std::size_t begin;  // index of its first point
  };

  // The first cell, from `from` on, that is not below a place; num_cells() if there is none.
  std::size_t seek(std::size_t from, const Place& place) const;

  // The points of the cells from `first` up to a place.
  std::span<const std::uint32_t> points_up_to(std::size_t first, const Place& last) const;

  std::vector<Cell> cells_;  // ordered by their places
  std::vector<std::uint32_t> points_;
};

// Visits the cells in ascending order: what touches the next cell lies not far behind what touched the last one.
class CellGrid::Walk {
 public:
  // REQUIRES: the grid outlives the walk.
  Walk(const CellGrid& grid, std::size_t first_cell) : grid_(grid), cell_(first_cell) {}

  // Fills `points` with the points of the next cell and of all cells that touch it, each once, in an order that depends
  // on the cloud only. An out-argument, so that all cells share one buffer.
  void next(std::vector<std::uint32_t>& points);

 private:
  const CellGrid& grid_;
  std::size_t cell_;
  std::array<std::size_t, 9> columns_{};  // begin of the cells that touched the last cell
};

}  // namespace augicp
