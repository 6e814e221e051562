// SPDX-License-Identifier: MIT
#include "augicp/search/cell_grid.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <utility>

#include "augicp/core/check.h"

namespace augicp {
namespace {

// So much larger than the distance are cells that no rounding puts two points nearer than it two cells apart.
constexpr double kCellPerDistance = 1.0 + 1e-5;

// From so many cells on, neighbouring floats are more than a cell apart, so that only equal ones are near each other: each then has
// a place of its own, far from all others. Counting cells there would put many into one, or leave the range of integers.
constexpr double kCountedCells = 1 << 26;
constexpr std::int64_t kApart = std::int64_t{1} << 28;

std::int64_t place_of(float coordinate, double cell) {
  const double place = static_cast<double>(coordinate) / cell;
  if (std::abs(place) < kCountedCells) return static_cast<std::int64_t>(std::floor(place));
  return kApart * std::bit_cast<std::int32_t>(coordinate);
}

}  // namespace

CellGrid::CellGrid(const Cloud& cloud, double distance) {
  require_positive("distance", distance);
  const double cell = kCellPerDistance * distance;
  std::vector<std::pair<Place, std::uint32_t>> placed(cloud.size());
  for (std::uint32_t i = 0; i < placed.size(); ++i) {
    const Vec3f& point = cloud.points[i];
    placed[i] = {{place_of(point.x(), cell), place_of(point.y(), cell), place_of(point.z(), cell)}, i};
  }
  std::sort(placed.begin(), placed.end());
  points_.reserve(placed.size());
  for (const auto& [place, point] : placed) {
    if (cells_.empty() || cells_.back().place != place) cells_.push_back({place, points_.size()});
    points_.push_back(point);
  }
}

std::span<const std::uint32_t> CellGrid::points_of(std::size_t cell) const {
  const std::size_t end = cell + 1 < cells_.size() ? cells_[cell + 1].begin : points_.size();
  return std::span(points_).subspan(cells_[cell].begin, end - cells_[cell].begin);
}

std::span<const std::uint32_t> CellGrid::points_in_column(const Place& first, std::int64_t last_z) const {
  const auto begin = std::partition_point(cells_.begin(), cells_.end(), [&](const Cell& c) { return c.place < first; });
  const Place last{first[0], first[1], last_z};
  auto end = begin;
  while (end != cells_.end() && end->place <= last) ++end;
  const auto first_point = [&](auto cell) { return cell == cells_.end() ? points_.size() : cell->begin; };
  return std::span(points_).subspan(first_point(begin), first_point(end) - first_point(begin));
}

void CellGrid::around(std::size_t cell, std::vector<std::uint32_t>& points) const {
  points.clear();
  const auto [x, y, z] = cells_[cell].place;
  for (const std::int64_t dx : {-1, 0, 1})
    for (const std::int64_t dy : {-1, 0, 1}) {  // three cells along z follow one another
      const auto column = points_in_column({x + dx, y + dy, z - 1}, z + 1);
      points.insert(points.end(), column.begin(), column.end());
    }
  std::sort(points.begin(), points.end());
}

}  // namespace augicp
