// SPDX-License-Identifier: MIT
#include "augicp/odometry/map_archive.h"

#include <cmath>
#include <limits>

#include "augicp/registration/memory.h"

namespace augicp {
namespace {

// Of the reach. What is nearer than the first is seen well enough to replace what was there; the second is how far the
// sensor may go between updates.
constexpr double kReplacedShare = 0.5;
constexpr double kUpdateShare = 0.25;

// A node of the map and what the allocator adds, and a point of a tile.
constexpr double kBytesPerArchivedPoint = 150.0;

}  // namespace

double MapArchive::memory_gb() const { return kBytesPerArchivedPoint * static_cast<double>(size()) / kBytesPerGb; }

bool MapArchive::is_due(const Vec3d& place_in_world) const {
  return !has_place_ || (place_in_world - place_).norm() > kUpdateShare * reach_;
}

void MapArchive::update(const Cloud& local_map, const Vec3d& place_in_world) {
  const double near_sq = kReplacedShare * reach_ * kReplacedShare * reach_;
  const auto is_near = [&](const Vec3d& place) { return (place - place_in_world).squaredNorm() < near_sq; };
  for (std::size_t i = 0; i < local_map.size(); ++i) {
    const Vec3d place = local_map.origin + local_map.points[i].cast<double>();
    const Vec3d cell = (place / voxel_size_).array().floor();
    const Index index{static_cast<int>(cell[0]), static_cast<int>(cell[1]), static_cast<int>(cell[2])};
    const float intensity =
        local_map.has_intensities() ? local_map.intensities[i] : std::numeric_limits<float>::quiet_NaN();
    const Point point{place, local_map.directions[i], local_map.structures[i], intensity};
    if (is_near(place))
      points_.insert_or_assign(index, point);
    else
      points_.try_emplace(index, point);
  }
  place_ = place_in_world;
  has_place_ = true;
}

std::map<std::array<int, 2>, Cloud> MapArchive::tiles(double edge) const {
  std::map<std::array<int, 2>, Cloud> tiles;
  for (const auto& [index, point] : points_) {
    const Eigen::Vector2d number = (point.place.head<2>() / edge).array().floor();
    const bool is_one = !std::isfinite(edge);
    const std::array<int, 2> tile =
        is_one ? std::array{0, 0} : std::array{static_cast<int>(number[0]), static_cast<int>(number[1])};
    Cloud& cloud = tiles[tile];
    if (!is_one) cloud.origin = {edge * tile[0], edge * tile[1], 0.0};
    cloud.points.push_back((point.place - cloud.origin).cast<float>());
    cloud.directions.push_back(point.direction);
    cloud.structures.push_back(point.structure);
    cloud.intensities.push_back(point.intensity);
  }
  for (auto& [number, cloud] : tiles) {
    bool is_known = false;
    for (const float intensity : cloud.intensities) is_known = is_known || !std::isnan(intensity);
    if (!is_known) cloud.intensities.clear();
  }
  return tiles;
}

}  // namespace augicp
