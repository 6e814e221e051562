// SPDX-License-Identifier: MIT
#include "augicp/odometry/surface_map.h"

#include <cmath>
#include <limits>
#include <unordered_set>
#include <utility>

#include "augicp/core/check.h"

namespace augicp {
namespace {

// Sizes of the voxels that help where a voxel shows no surface by itself.
constexpr std::array<int, 2> kCoarser{2, 4};

// A point farther from a coarser plane than this many of the plane's thicknesses belongs to something else.
constexpr double kMaxThicknesses = 3.0;

// Points of one scan show a coarser plane if there are this many times min_points. With fewer, a part of a ring and a
// column of rays that cross a corner look like a plane across the line of sight, which moves with the sensor.
constexpr double kCoarsePointsFactor = 3.0;

// Points of one ring that cross a corner look like such a plane, too. Their elevations are equal; those of neighbouring
// rings differ by more than this, radians.
constexpr double kMinElevationSpread = 3e-4;

constexpr std::int32_t kMaxIndex = 1 << 20;

// Its sine, which serves as well as the angle near the horizon.
double elevation_of(const Vec3d& point) {
  const double distance = point.norm();
  return distance > 0.0 ? point.z() / distance : 0.0;
}

std::int32_t floor_divided(std::int32_t a, std::int32_t b) { return a >= 0 ? a / b : -((-a + b - 1) / b); }

}  // namespace

struct SurfaceMap::Level {
  int factor = 1;
  std::unordered_map<std::uint64_t, std::uint32_t> place;
  std::vector<Sums> sums;
  std::vector<std::optional<Shape>> shapes;  // of those that were asked for
};

void SurfaceMapOptions::check() const {
  require_positive("voxel_size", voxel_size);
  require(max_count >= thresholds.min_points, "max_count", max_count, "must be at least thresholds.min_points");
  require(min_scans_of_edge >= 1, "min_scans_of_edge", min_scans_of_edge, "must be at least 1");
}

SurfaceMap::SurfaceMap(const SurfaceMapOptions& options) : options_(options) { options.check(); }

void SurfaceMap::Sums::add(const Sums& other) {
  const Vec3d shift = other.centre - centre;
  outer += other.outer + shift * other.sum.transpose() + other.sum * shift.transpose() +
           other.count * shift * shift.transpose();
  sum += other.sum + other.count * shift;
  count += other.count;
  elevation += other.elevation;
  elevation_sq += other.elevation_sq;
}

bool SurfaceMap::Sums::is_of_one_ring() const {
  const double mean = elevation / count;
  return elevation_sq / count - mean * mean < kMinElevationSpread * kMinElevationSpread;
}

Gaussian SurfaceMap::Sums::gaussian() const {
  const Vec3d mean = sum / count;
  return {count, centre + mean, outer / count - mean * mean.transpose()};
}

void SurfaceMap::Sums::scale(double factor) {
  count *= factor, sum *= factor, outer *= factor;
  elevation *= factor, elevation_sq *= factor;
  intensity *= factor, intensity_count *= factor;
}

float SurfaceMap::Sums::mean_intensity() const {
  return intensity_count > 0.0 ? static_cast<float>(intensity / intensity_count)
                               : std::numeric_limits<float>::quiet_NaN();
}

std::uint64_t SurfaceMap::key_of(const Index& index) {
  std::uint64_t key = 0;
  for (const std::int32_t i : index) key = key << 21 | static_cast<std::uint64_t>(i + kMaxIndex);
  return key;
}

// None beyond the grid.
std::optional<SurfaceMap::Index> SurfaceMap::index_at(const Vec3d& place_in_map) const {
  const Vec3d cell = (place_in_map / options_.voxel_size).array().floor();
  if (!(cell.cwiseAbs().maxCoeff() < kMaxIndex)) return std::nullopt;
  return Index{static_cast<std::int32_t>(cell[0]), static_cast<std::int32_t>(cell[1]),
               static_cast<std::int32_t>(cell[2])};
}

SurfaceMap::Sums& SurfaceMap::sums_at(const Index& index) {
  if (last_hit_ < voxels_.size() && voxels_[last_hit_].index == index) return voxels_[last_hit_].sums;
  const auto [found, is_new] = place_.try_emplace(key_of(index), static_cast<std::uint32_t>(voxels_.size()));
  if (is_new) {
    Voxel voxel;
    voxel.index = index;
    for (int k = 0; k < 3; ++k) voxel.sums.centre[k] = (index[static_cast<std::size_t>(k)] + 0.5) * options_.voxel_size;
    voxels_.push_back(voxel);
  }
  last_hit_ = found->second;
  return voxels_[last_hit_].sums;
}

void SurfaceMap::add(const Cloud& scan, const Rigid3& map_from_scan) {
  const Mat3d rotation = map_from_scan.rotation.toRotationMatrix();
  const Vec3d origin = map_from_scan * scan.origin;
  for (std::size_t i = 0; i < scan.size(); ++i) {
    const Vec3f& point = scan.points[i];
    const Vec3d in_map = origin + rotation * point.cast<double>();
    const std::optional<Index> index = index_at(in_map);
    if (!index) continue;
    Sums& sums = sums_at(*index);
    if (sums.count >= options_.max_count) sums.scale((options_.max_count - 1.0) / sums.count);
    const Vec3d offset = in_map - sums.centre;
    sums.count += 1.0;
    sums.sum += offset;
    sums.outer += offset * offset.transpose();
    const double elevation = elevation_of(scan.origin + point.cast<double>());
    sums.elevation += elevation;
    sums.elevation_sq += elevation * elevation;
    if (scan.has_intensities() && !std::isnan(scan.intensities[i]))
      sums.intensity += static_cast<double>(scan.intensities[i]), sums.intensity_count += 1.0;
    if (sums.last_scan != num_scans_) ++sums.num_scans, sums.last_scan = num_scans_;
  }
  ++num_scans_;
}

// The voxels that are kept stay in their order.
template <typename Keep>
void SurfaceMap::keep_if(const Keep& keep) {
  std::vector<Voxel> kept;
  for (const Voxel& voxel : voxels_)
    if (keep(voxel)) kept.push_back(voxel);
  if (kept.size() == voxels_.size()) return;
  voxels_ = std::move(kept);
  place_.clear();
  for (std::uint32_t i = 0; i < voxels_.size(); ++i) place_.emplace(key_of(voxels_[i].index), i);
}

void SurfaceMap::forget_beyond(const Vec3d& centre_in_map, double distance) {
  keep_if([&](const Voxel& voxel) { return (voxel.sums.centre - centre_in_map).norm() <= distance; });
}

void SurfaceMap::forget_at(const std::vector<Vec3d>& places_in_map) {
  std::unordered_set<std::uint64_t> gone;
  for (const Vec3d& place : places_in_map)
    if (const std::optional<Index> index = index_at(place)) gone.insert(key_of(*index));
  if (!gone.empty()) keep_if([&](const Voxel& voxel) { return !gone.contains(key_of(voxel.index)); });
}

Shape SurfaceMap::shape_of(const Sums& sums) const {
  const ShapeThresholds& thresholds = options_.thresholds;
  if (sums.count < thresholds.min_points) return {};
  const Eigen3 eigen = eigen_of_symmetric(sums.gaussian().covariance);
  const double l0 = std::max(eigen.values[0], 0.0), l1 = eigen.values[1], l2 = eigen.values[2];
  if (is_line(l1, l2, thresholds)) {
    if (sums.num_scans < options_.min_scans_of_edge) return {};
    return {Structure::Edge, eigen.vectors.col(2)};
  }
  if (sums.is_of_one_ring()) return {};
  if (l0 < thresholds.max_planar_curvature * (l0 + l1 + l2)) return {Structure::Planar, eigen.vectors.col(0)};
  return {};
}

SurfaceMap::Level SurfaceMap::coarser_level(int factor) const {
  Level level;
  level.factor = factor;
  for (const Voxel& voxel : voxels_) {
    Index index = voxel.index;
    for (std::int32_t& i : index) i = floor_divided(i, factor);
    const auto [found, is_new] = level.place.try_emplace(key_of(index), static_cast<std::uint32_t>(level.sums.size()));
    if (is_new) {
      level.sums.emplace_back();
      level.sums.back().centre = voxel.sums.centre;
    }
    level.sums[found->second].add(voxel.sums);
  }
  level.shapes.resize(level.sums.size());
  return level;
}

Shape SurfaceMap::shape_in(const Voxel& voxel, std::vector<Level>& coarser, double min_coarse_count,
                           Vec3d& mean) const {
  Shape own = shape_of(voxel.sums);
  const Vec3d own_mean = voxel.sums.centre + voxel.sums.sum / voxel.sums.count;
  mean = own_mean;
  const bool shows_its_shape = voxel.sums.count >= options_.thresholds.min_points && !voxel.sums.is_of_one_ring();
  if (own.structure != Structure::None || shows_its_shape) return own;
  for (Level& level : coarser) {
    Index index = voxel.index;
    for (std::int32_t& i : index) i = floor_divided(i, level.factor);
    const std::uint32_t at = level.place.at(key_of(index));
    if (level.sums[at].count < min_coarse_count) continue;
    if (!level.shapes[at]) level.shapes[at] = shape_of(level.sums[at]);
    const Shape& shape = *level.shapes[at];
    if (shape.structure != Structure::Planar) continue;
    const Gaussian gaussian = level.sums[at].gaussian();
    const double off = shape.direction.dot(own_mean - gaussian.mean);
    const double thickness = std::sqrt(std::max(0.0, shape.direction.dot(gaussian.covariance * shape.direction)));
    if (std::abs(off) > kMaxThicknesses * thickness) continue;
    mean = own_mean - off * shape.direction;
    return shape;
  }
  return own;
}

std::vector<SurfaceMap::Level> SurfaceMap::coarser_levels() const {
  std::vector<Level> levels;
  levels.reserve(kCoarser.size());
  for (const int factor : kCoarser) levels.push_back(coarser_level(factor));
  return levels;
}

Cloud SurfaceMap::surfaces(const Vec3d& origin_in_map) const {
  Cloud cloud;
  cloud.origin = origin_in_map;
  std::vector<Level> coarser = coarser_levels();
  bool has_intensities = false;
  for (const Voxel& voxel : voxels_) {
    Vec3d mean;
    const Shape shape = shape_in(voxel, coarser, options_.thresholds.min_points, mean);
    if (shape.structure == Structure::None) continue;
    cloud.points.push_back((mean - origin_in_map).cast<float>());
    cloud.directions.push_back(shape.direction.cast<float>());
    cloud.structures.push_back(shape.structure);
    cloud.intensities.push_back(voxel.sums.mean_intensity());
    has_intensities = has_intensities || voxel.sums.intensity_count > 0.0;
  }
  if (!has_intensities) cloud.intensities.clear();
  return cloud;
}

void SurfaceMap::describe(Cloud& cloud, const Rigid3& map_from_cloud) const {
  std::vector<Level> coarser = coarser_levels();
  std::vector<Shape> shapes;
  shapes.reserve(voxels_.size());
  const double min_count = kCoarsePointsFactor * options_.thresholds.min_points;
  for (Vec3d mean; const Voxel& voxel : voxels_) shapes.push_back(shape_in(voxel, coarser, min_count, mean));
  cloud.directions.assign(cloud.size(), Vec3f::Zero());
  cloud.structures.assign(cloud.size(), Structure::None);
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    const std::optional<Index> index = index_at(map_from_cloud * (cloud.origin + cloud.points[i].cast<double>()));
    if (!index) continue;
    const auto found = place_.find(key_of(*index));
    if (found == place_.end() || shapes[found->second].structure == Structure::None) continue;
    const Shape& shape = shapes[found->second];
    cloud.structures[i] = shape.structure;
    cloud.directions[i] = (map_from_cloud.rotation.conjugate() * shape.direction).cast<float>();
  }
}

}  // namespace augicp
