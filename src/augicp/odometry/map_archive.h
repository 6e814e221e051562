// SPDX-License-Identifier: MIT
// The map of a whole run, from what an odometry remembers around the sensor from time to time.
#pragma once

#include <array>
#include <cstddef>
#include <map>
#include <vector>

#include "augicp/cloud/cloud.h"

namespace augicp {

// One extended point a voxel: the last one that was seen there. Memory grows with the mapped place, not with time.
// Invariant: the result depends on the updates and their order alone. Not for concurrent use.
class MapArchive {
 public:
  // voxel_size, reach: of the odometry, metres. REQUIRES: both above 0.
  MapArchive(double voxel_size, double reach) : voxel_size_(voxel_size), reach_(reach) {}

  // Whether the sensor is so far from the place of the last update that surfaces may be forgotten before the next one.
  bool is_due(const Vec3d& place_in_world) const;

  // local_map: of an odometry, see LidarOdometry::map(); the sensor is at this place. Within half of the reach its
  // points replace those in their voxels. Farther away they fill empty voxels only. Nothing is taken away: where the
  // sensor comes back, its local map has forgotten the place and has seen little of it again.
  void update(const Cloud& local_map, const Vec3d& place_in_world);

  std::size_t size() const { return points_.size(); }

  // 10^9 bytes, with the copy that tiles() makes: an estimate.
  double memory_gb() const;

  // The map in tiles with edges of this length in x and y, metres, whose corner is a multiple of it: by the number of
  // the tile along each axis. Infinity: one tile. Each cloud's origin is its tile's corner; that of one tile is zero.
  std::map<std::array<int, 2>, Cloud> tiles(double edge) const;

 private:
  using Index = std::array<int, 3>;
  struct Point {
    Vec3d place;
    Vec3f direction;
    Structure structure;
    float intensity;  // NaN: unknown
  };

  double voxel_size_, reach_;
  bool has_place_ = false;
  Vec3d place_ = Vec3d::Zero();
  std::map<Index, Point> points_;
};

}  // namespace augicp
