// SPDX-License-Identifier: MIT
#include "augicp/match/range_image.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

#include "augicp/match/cube_cells.h"
#include "augicp/match/ray_spacing.h"

namespace augicp {
namespace {

// Of the cells that have points: a cell then has its range even where the points are sparse by chance.
constexpr std::size_t kPointsPerCell = 4;
// Seen from very far, a cloud falls into few cells however fine they are: these tell nothing.
constexpr std::size_t kMaxPointsPerCell = 128;
constexpr int kMinCellsPerEdge = 8, kMaxCellsPerEdge = 256;

// From the right place at most 0.1 % of the points of cluttered rooms lie behind others. From a place 1 m away in the
// room mostly 1 % and more do.
constexpr double kMaxShareBehindUnknown = 0.01;

std::size_t num_occupied(const std::vector<FacePoint>& points, int cells_per_edge) {
  std::vector<std::uint8_t> is_occupied(num_cube_cells(cells_per_edge));
  std::size_t count = 0;
  for (const FacePoint& at : points) {
    std::uint8_t& occupied = is_occupied[cell_of(at, cells_per_edge)];
    count += 1U - occupied;
    occupied = 1;
  }
  return count;
}

int cells_for(const std::vector<FacePoint>& points) {
  int cells = kMaxCellsPerEdge;
  while (cells > kMinCellsPerEdge && num_occupied(points, cells) * kPointsPerCell > points.size()) cells /= 2;
  return cells;
}

}  // namespace

RangeImage::RangeImage(const Cloud& cloud, const Vec3f& place) : cloud_(cloud), place_(place) {
  std::vector<FacePoint> seen;
  std::vector<std::int32_t> indices;
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    const Vec3f ray = cloud.points[i] - place;
    if (!(ray.squaredNorm() > 0.0f)) continue;
    seen.push_back(on_cube(ray));
    indices.push_back(static_cast<std::int32_t>(i));
  }
  cells_per_edge_ = cells_for(seen);
  own_ = spread_ = empty_cells();
  for (std::size_t k = 0; k < seen.size(); ++k) {
    const float range = (cloud.points[indices[k]] - place).norm();
    add(own_, cell_of(seen[k], cells_per_edge_), indices[k], range);
    for (const std::size_t beside : cells_around(seen[k], cells_per_edge_)) add(spread_, beside, indices[k], range);
  }
}

std::vector<RangeImage::Cell> RangeImage::empty_cells() const {
  return std::vector<Cell>(num_cube_cells(cells_per_edge_), Cell{std::numeric_limits<float>::infinity(), 0.0f, kNone});
}

void RangeImage::add(std::vector<Cell>& cells, std::size_t cell, std::int32_t point, float range) const {
  Cell& at = cells[cell];
  at.farthest_range = std::max(at.farthest_range, range);
  if (!(range < at.nearest_range)) return;
  at.nearest_range = range;
  at.nearest_point = point;
}

// Whether a place is farther than the tolerance from the plane of a point; true if the point has no plane.
bool RangeImage::is_off_plane(std::int32_t point, const Vec3f& place, float tolerance) const {
  const auto i = static_cast<std::size_t>(point);
  if (!cloud_.has_directions() || cloud_.structures[i] != Structure::Planar) return true;
  return std::abs(cloud_.directions[i].dot(place - cloud_.points[i])) > tolerance;
}

Sight RangeImage::sight(const Vec3f& point, float tolerance) const {
  const Vec3f ray = point - place_;
  const float range = ray.norm();
  if (!(range > 0.0f)) return Sight::OutOfView;
  const Cell& cell = spread_[cell_of(on_cube(ray), cells_per_edge_)];
  if (cell.nearest_point == kNone) return Sight::OutOfView;
  const bool is_in_front = cell.nearest_range - range > tolerance && is_off_plane(cell.nearest_point, point, tolerance);
  if (is_in_front) return Sight::Free;
  return range - cell.farthest_range > tolerance ? Sight::Hidden : Sight::AtSurface;
}

bool RangeImage::is_behind_all_around(const Vec3f& point, float tolerance) const {
  const Vec3f ray = point - place_;
  const float range = ray.norm();
  if (!(range > 0.0f)) return false;
  for (const std::size_t beside : cells_around(on_cube(ray), cells_per_edge_)) {
    const Cell& cell = own_[beside];
    if (cell.nearest_point == kNone) continue;
    if (!(range - cell.nearest_range > tolerance) || !is_off_plane(cell.nearest_point, point, tolerance)) return false;
  }
  return true;
}

double RangeImage::share_behind(float tolerance) const {
  const auto behind = std::count_if(cloud_.points.begin(), cloud_.points.end(),
                                    [&](const Vec3f& point) { return is_behind_all_around(point, tolerance); });
  return cloud_.empty() ? 0.0 : static_cast<double>(behind) / static_cast<double>(cloud_.size());
}

bool RangeImage::is_fine_enough() const {
  const auto num_filled =
      std::count_if(own_.begin(), own_.end(), [](const Cell& cell) { return cell.nearest_point != kNone; });
  return static_cast<std::size_t>(num_filled) * kMaxPointsPerCell >= cloud_.size();
}

std::optional<RangeImage> lines_of_sight(const Cloud& cloud, float tolerance, bool place_is_known) {
  if (cloud.empty()) return std::nullopt;
  RangeImage image(cloud, assumed_place(cloud));
  if (!image.is_fine_enough()) return std::nullopt;
  if (!place_is_known && !(image.share_behind(tolerance) <= kMaxShareBehindUnknown)) return std::nullopt;
  return image;
}

}  // namespace augicp
