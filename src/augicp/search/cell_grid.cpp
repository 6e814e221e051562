// SPDX-License-Identifier: MIT
#include "augicp/search/cell_grid.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "augicp/core/check.h"

namespace augicp {
namespace {

// So much larger than the distance are cells that no rounding puts two points nearer than it two cells apart.
constexpr double kCellPerDistance = 1.0 + 1e-5;

// Beyond, floats are so far apart that only equal ones are near each other. Leaves room for the cells beside.
constexpr double kLargest = 1e18;

}  // namespace

CellGrid::CellGrid(const Cloud& cloud, double distance) {
  require_positive("distance", distance);
  const Vec3d min = bounds(cloud).min.cast<double>();
  const double cell = kCellPerDistance * distance;
  std::vector<std::pair<Place, std::uint32_t>> placed(cloud.size());
  for (std::uint32_t i = 0; i < placed.size(); ++i) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const auto k = static_cast<Eigen::Index>(axis);
      const double offset = static_cast<double>(cloud.points[i][k]) - min[k];  // never negative: truncation is the floor
      placed[i].first[axis] = static_cast<std::int64_t>(std::min(offset / cell, kLargest));
    }
    placed[i].second = i;
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

std::size_t CellGrid::first_point_from(const Place& place) const {
  const auto cell = std::partition_point(cells_.begin(), cells_.end(), [&](const Cell& c) { return c.place < place; });
  return cell == cells_.end() ? points_.size() : cell->begin;
}

void CellGrid::around(std::size_t cell, std::vector<std::uint32_t>& points) const {
  points.clear();
  const auto [x, y, z] = cells_[cell].place;
  for (const std::int64_t dx : {-1, 0, 1})
    for (const std::int64_t dy : {-1, 0, 1}) {  // three cells along z follow one another
      const std::size_t begin = first_point_from({x + dx, y + dy, z - 1}), end = first_point_from({x + dx, y + dy, z + 2});
      points.insert(points.end(), points_.begin() + static_cast<std::ptrdiff_t>(begin),
                    points_.begin() + static_cast<std::ptrdiff_t>(end));
    }
  std::sort(points.begin(), points.end());
}

}  // namespace augicp
