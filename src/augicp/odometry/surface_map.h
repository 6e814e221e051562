// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <unordered_map>
#include <vector>

#include "augicp/cloud/cloud.h"
#include "augicp/surface/shape.h"

namespace augicp {

struct SurfaceMapOptions {
  double voxel_size = 0.5;  // metres, above 0

  // A voxel remembers about this many points: with more, the older ones count less.
  double max_count = 400.0;

  // A line in a voxel is an edge only after points of this many scans. The points of one ring on a wall are a line too,
  // but rings move with the sensor, so that those of several scans fill the wall.
  int min_scans_of_edge = 3;

  ShapeThresholds thresholds;

  // Throws std::invalid_argument naming the first option out of its range.
  void check() const;
};

// Gaussians of the points of many scans, one a voxel of a grid in the map's frame, and the surfaces that they show.
// The same scans in the same order give the same map. Not for concurrent use.
//
// Invariants: voxels_ is in the order in which the voxels were first hit; place_ has one entry for each of them.
class SurfaceMap {
 public:
  explicit SurfaceMap(const SurfaceMapOptions& options);

  // The scan is in the frame of a sensor, whose rings have elevations above its x-y plane. Points farther than 2^20
  // voxels from the zero of the map along an axis are ignored.
  void add(const Cloud& scan, const Rigid3& map_from_scan);

  // Removes the voxels whose centre is farther from a place than this, metres.
  void forget_beyond(const Vec3d& centre_in_map, double distance);

  // Removes the voxels in which these places lie. Places without a voxel are ignored.
  void forget_at(const std::vector<Vec3d>& places_in_map);

  // One extended point a voxel that shows a surface: its mean, and the normal or tangent. Where a voxel has too few
  // points to show one (far from the sensor), the plane of the voxel of twice or four times the size around it is
  // taken, and the mean is moved onto that plane. The cloud's origin is the given one. Intensities are those of
  // the scans' points, averaged; NaN where none is known.
  Cloud surfaces(const Vec3d& origin_in_map) const;

  // Directions and structures for a cloud from the surfaces of the voxels in which its points lie, found as for
  // surfaces(), but with more care for what a single scan shows; None elsewhere.
  void describe(Cloud& cloud, const Rigid3& map_from_cloud) const;

  std::size_t num_voxels() const { return voxels_.size(); }

 private:
  using Index = std::array<std::int32_t, 3>;
  struct Sums {  // of points relative to `centre`
    Vec3d centre = Vec3d::Zero();
    double count = 0.0;
    Vec3d sum = Vec3d::Zero();
    Mat3d outer = Mat3d::Zero();
    double elevation = 0.0, elevation_sq = 0.0;  // sines, in the scans' frames
    double intensity = 0.0, intensity_count = 0.0;
    int num_scans = 0;
    int last_scan = -1;
    void add(const Sums& other);
    void scale(double factor);
    Gaussian gaussian() const;
    bool is_of_one_ring() const;
    float mean_intensity() const;
  };
  struct Voxel {
    Index index{};
    Sums sums;
  };
  struct Level;

  static std::uint64_t key_of(const Index& index);
  std::optional<Index> index_at(const Vec3d& place_in_map) const;
  template <typename Keep>
  void keep_if(const Keep& keep);
  Sums& sums_at(const Index& index);
  Shape shape_of(const Sums& sums) const;
  Level coarser_level(int factor) const;
  std::vector<Level> coarser_levels() const;
  Shape shape_in(const Voxel& voxel, std::vector<Level>& coarser, double min_coarse_count, Vec3d& mean) const;

  SurfaceMapOptions options_;
  std::unordered_map<std::uint64_t, std::uint32_t> place_;
  std::vector<Voxel> voxels_;
  std::size_t last_hit_ = 0;  // mostly that of the next point, too
  int num_scans_ = 0;
};

}  // namespace augicp
