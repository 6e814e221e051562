// SPDX-License-Identifier: MIT
#include "augicp/search/cell_grid.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <numeric>
#include <optional>
#include <tuple>

#include "augicp/core/check.h"

namespace augicp {
namespace {

// Cells are this much larger than the distance, so that rounding never puts two points closer than the distance two
// cells apart.
constexpr double kCellPerDistance = 1.0 + 1e-5;

// From this many cells on, neighbouring floats are more than a cell apart, so only equal points are near each other.
// Each value then gets a cell of its own, far from all others. Counting cells would put many values into one cell, or
// overflow the integers.
constexpr double kCountedCells = 1 << 26;
constexpr std::int64_t kApart = std::int64_t{1} << 28;

std::int64_t place_of(float coordinate, double cell) {
  const double place = static_cast<double>(coordinate) / cell;
  if (std::abs(place) < kCountedCells) return static_cast<std::int64_t>(std::floor(place));
  return kApart * std::bit_cast<std::int32_t>(coordinate);
}

using Place = std::array<std::int64_t, 3>;

// A point and its place as one number, for places in a small enough box: sorted in a fraction of the time.
constexpr int kAxisBits = 14, kIndexBits = 64 - 3 * kAxisBits;

std::optional<std::vector<std::uint64_t>> packed(const std::vector<Place>& places) {
  constexpr std::int64_t kMaxCells = std::int64_t{1} << kAxisBits;
  if (places.empty() || places.size() > std::size_t{1} << kIndexBits) return std::nullopt;
  Place low = places.front(), high = low;
  for (const Place& place : places)
    for (std::size_t k = 0; k < 3; ++k) low[k] = std::min(low[k], place[k]), high[k] = std::max(high[k], place[k]);
  for (std::size_t k = 0; k < 3; ++k)
    if (high[k] - low[k] >= kMaxCells) return std::nullopt;
  std::vector<std::uint64_t> numbers(places.size());
  for (std::size_t i = 0; i < places.size(); ++i) {
    for (std::size_t k = 0; k < 3; ++k)
      numbers[i] = numbers[i] << kAxisBits | static_cast<std::uint64_t>(places[i][k] - low[k]);
    numbers[i] = numbers[i] << kIndexBits | i;
  }
  return numbers;
}

// The indices of the points, sorted by place, and within a place in ascending order.
std::vector<std::uint32_t> sorted_by_place(const std::vector<Place>& places) {
  std::vector<std::uint32_t> order(places.size());
  if (auto numbers = packed(places)) {
    std::sort(numbers->begin(), numbers->end());
    constexpr std::uint64_t kIndex = (std::uint64_t{1} << kIndexBits) - 1;
    for (std::size_t k = 0; k < order.size(); ++k) order[k] = static_cast<std::uint32_t>((*numbers)[k] & kIndex);
    return order;
  }
  std::iota(order.begin(), order.end(), 0U);
  std::sort(order.begin(), order.end(),
            [&](std::uint32_t a, std::uint32_t b) { return std::tie(places[a], a) < std::tie(places[b], b); });
  return order;
}

}  // namespace

CellGrid::CellGrid(const Cloud& cloud, double distance) {
  require_positive("distance", distance);
  const double cell = kCellPerDistance * distance;
  std::vector<Place> places(cloud.size());
  for (std::size_t i = 0; i < places.size(); ++i) {
    const Vec3f& point = cloud.points[i];
    places[i] = {place_of(point.x(), cell), place_of(point.y(), cell), place_of(point.z(), cell)};
  }
  points_ = sorted_by_place(places);
  for (std::size_t k = 0; k < points_.size(); ++k)
    if (const Place& place = places[points_[k]]; cells_.empty() || cells_.back().place != place)
      cells_.push_back({place, k});
}

std::span<const std::uint32_t> CellGrid::points_of(std::size_t cell) const {
  const std::size_t end = cell + 1 < cells_.size() ? cells_[cell + 1].begin : points_.size();
  return std::span(points_).subspan(cells_[cell].begin, end - cells_[cell].begin);
}

std::size_t CellGrid::cell_at(std::size_t rank) const {
  const auto after = std::upper_bound(cells_.begin(), cells_.end(), rank,
                                      [](std::size_t place, const Cell& cell) { return place < cell.begin; });
  return static_cast<std::size_t>(after - cells_.begin()) - 1;
}

std::size_t CellGrid::seek(std::size_t from, const Place& place) const {
  const auto is_below = [&](const Cell& cell) { return cell.place < place; };
  std::size_t step = 1;
  while (from + step < cells_.size() && is_below(cells_[from + step])) from += step, step *= 2;
  const auto begin = cells_.begin() + static_cast<std::ptrdiff_t>(from),
             end = cells_.begin() + static_cast<std::ptrdiff_t>(std::min(from + step, cells_.size()));
  return static_cast<std::size_t>(std::partition_point(begin, end, is_below) - cells_.begin());
}

std::span<const std::uint32_t> CellGrid::points_up_to(std::size_t first, const Place& last) const {
  std::size_t end = first;
  while (end < cells_.size() && cells_[end].place <= last) ++end;
  const auto first_point = [&](std::size_t cell) {
    return cell == cells_.size() ? points_.size() : cells_[cell].begin;
  };
  return std::span(points_).subspan(first_point(first), first_point(end) - first_point(first));
}

void CellGrid::Walk::next(std::vector<std::uint32_t>& points) {
  points.clear();
  const auto [x, y, z] = grid_.cells_[cell_++].place;
  std::size_t* column = columns_.data();
  for (const std::int64_t dx : {-1, 0, 1})
    for (const std::int64_t dy : {-1, 0, 1}) {  // three cells along z are consecutive
      *column = grid_.seek(*column, {x + dx, y + dy, z - 1});
      const auto in_column = grid_.points_up_to(*column++, {x + dx, y + dy, z + 1});
      points.insert(points.end(), in_column.begin(), in_column.end());
    }
}

}  // namespace augicp
