// SPDX-License-Identifier: MIT
#include "augicp/odometry/seen_through.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "augicp/core/angles.h"

namespace augicp {
namespace {

// A ray crosses the surface of a voxel if it meets the plane this near to its point, voxels; of near voxels, within
// this angle of the line of sight, which limits the number of rays.
constexpr double kCrossingVoxels = 0.5;
constexpr double kMaxCrossingAngle = 2.5 * kRadPerDeg;

// Beyond the plane by more than this, voxels, a ray has passed; this near to it, it has ended there.
constexpr double kMarginVoxels = 1.0;

// Number of rays that must have passed. One or two may be wrong ranges.
constexpr int kMinRays = 3;

// Rays that graze a plane say little about where they cross it.
constexpr double kMinCosine = 0.15;

// Cells of the directions: evenly in azimuth and in the sine of the elevation.
constexpr int kAzimuthCells = 360, kElevationCells = 230;

// The rays of a scan, by their direction.
class Rays {
 public:
  explicit Rays(const Cloud& scan) {
    std::vector<std::uint32_t> cells;
    for (const Vec3f& point : scan.points) {
      const Vec3d ray = scan.origin + point.cast<double>();
      const double range = ray.norm();
      if (!(range > 0.0)) continue;
      unsorted_.push_back({(ray / range).cast<float>(), static_cast<float>(range)});
      cells.push_back(cell_of(azimuth_cell(ray), elevation_cell(ray.z() / range)));
    }
    sort_by(cells);
  }

  // Calls visit(direction, range) for the rays within about an angle of a unit direction.
  template <typename Visit>
  void near(const Vec3d& direction, double angle, const Visit& visit) const {
    const double cosine = std::max(0.05, direction.head<2>().norm());
    const int reach_azimuth = static_cast<int>(std::ceil(angle / cosine * kAzimuthCells / (2.0 * std::numbers::pi)));
    const int azimuth = azimuth_cell(direction);
    const int lowest = elevation_cell(direction.z() - angle), highest = elevation_cell(direction.z() + angle);
    for (int e = lowest; e <= highest; ++e)
      for (int a = azimuth - reach_azimuth; a <= azimuth + reach_azimuth; ++a) {
        const std::uint32_t cell = cell_of((a + kAzimuthCells) % kAzimuthCells, e);
        for (std::uint32_t k = begin_[cell]; k < begin_[cell + 1]; ++k) visit(rays_[k].direction, rays_[k].range);
      }
  }

 private:
  struct Ray {
    Vec3f direction;
    float range;
  };

  static int azimuth_cell(const Vec3d& ray) {
    const double turns = 0.5 + 0.5 * std::atan2(ray.y(), ray.x()) / std::numbers::pi;  // [0, 1]
    return std::min(kAzimuthCells - 1, static_cast<int>(turns * kAzimuthCells));
  }
  static int elevation_cell(double sine) {
    return std::clamp(static_cast<int>(0.5 * (sine + 1.0) * kElevationCells), 0, kElevationCells - 1);
  }
  static std::uint32_t cell_of(int azimuth, int elevation) {
    return static_cast<std::uint32_t>(elevation * kAzimuthCells + azimuth);
  }

  void sort_by(const std::vector<std::uint32_t>& cells) {
    begin_.assign(kAzimuthCells * kElevationCells + 1, 0);
    for (const std::uint32_t cell : cells) ++begin_[cell + 1];
    for (std::size_t c = 1; c < begin_.size(); ++c) begin_[c] += begin_[c - 1];
    rays_.resize(unsorted_.size());
    std::vector<std::uint32_t> next = begin_;
    for (std::size_t k = 0; k < cells.size(); ++k) rays_[next[cells[k]]++] = unsorted_[k];
    unsorted_.clear();
  }

  std::vector<Ray> unsorted_, rays_;
  std::vector<std::uint32_t> begin_;  // of each cell in rays_
};

// point, normal: in the sensor's frame.
bool is_seen_through(const Rays& rays, const Vec3d& point, const Vec3d& normal, double voxel_size) {
  const double range = point.norm();
  if (!(range > voxel_size)) return false;
  const double angle = std::min(kMaxCrossingAngle, kCrossingVoxels * voxel_size / range);
  const double reach_sq = angle * range * angle * range, margin = kMarginVoxels * voxel_size;
  int num_passed = 0, num_ended = 0;
  rays.near(point / range, angle, [&](const Vec3f& direction_f, float measured) {
    const Vec3d direction = direction_f.cast<double>();
    const double cosine = normal.dot(direction);
    if (std::abs(cosine) < kMinCosine) return;
    const double crossing = normal.dot(point) / cosine;
    if (!((crossing * direction - point).squaredNorm() <= reach_sq)) return;
    const double beyond = static_cast<double>(measured) - crossing;
    num_passed += beyond > margin;
    num_ended += std::abs(beyond) <= margin;
  });
  return num_passed >= kMinRays && num_ended == 0;
}

}  // namespace

std::vector<std::uint32_t> seen_through(const Cloud& surfaces, const Cloud& scan, const Rigid3& map_from_scan,
                                        double voxel_size) {
  const Rays rays(scan);
  const Rigid3 scan_from_map = inverse(map_from_scan);
  std::vector<std::uint32_t> gone;
  for (std::uint32_t i = 0; i < surfaces.size(); ++i) {
    if (surfaces.structures[i] != Structure::Planar) continue;
    const Vec3d point = scan_from_map * (surfaces.origin + surfaces.points[i].cast<double>());
    const Vec3d normal = scan_from_map.rotation * Vec3d(surfaces.directions[i].cast<double>());
    if (is_seen_through(rays, point, normal, voxel_size)) gone.push_back(i);
  }
  return gone;
}

}  // namespace augicp
