// SPDX-License-Identifier: MIT
#include "augicp/odometry/surface_map.h"

#include <cmath>

#include "augicp/core/check.h"

namespace augicp {
namespace {

// Sizes of the voxels that help where a voxel shows no surface by itself.
constexpr std::array<int, 2> kCoarser{2, 4};

// A point farther from a coarser plane than this many of the plane's thicknesses belongs to something else.
constexpr double kMaxThicknesses = 3.0;

constexpr std::int32_t kMaxIndex = 1 << 20;

std::int32_t floor_divided(std::int32_t a, std::int32_t b) { return a >= 0 ? a / b : -((-a + b - 1) / b); }

}  // namespace

struct SurfaceMap::Level {
  int factor = 1;
  std::unordered_map<std::uint64_t, std::uint32_t> place;
  std::vector<Sums> sums;
  std::vector<Shape> shapes;
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
}

Gaussian SurfaceMap::Sums::gaussian() const {
  const Vec3d mean = sum / count;
  return {count, centre + mean, outer / count - mean * mean.transpose()};
}

std::uint64_t SurfaceMap::key_of(const Index& index) {
  std::uint64_t key = 0;
  for (const std::int32_t i : index) key = key << 21 | static_cast<std::uint64_t>(i + kMaxIndex);
  return key;
}

SurfaceMap::Sums& SurfaceMap::sums_at(const Index& index) {
  const auto [found, is_new] = place_.try_emplace(key_of(index), static_cast<std::uint32_t>(voxels_.size()));
  if (is_new) {
    Voxel voxel;
    voxel.index = index;
    for (int k = 0; k < 3; ++k) voxel.sums.centre[k] = (index[static_cast<std::size_t>(k)] + 0.5) * options_.voxel_size;
    voxels_.push_back(voxel);
  }
  return voxels_[found->second].sums;
}

void SurfaceMap::add(const Cloud& scan, const Rigid3& map_from_scan) {
  const Mat3d rotation = map_from_scan.rotation.toRotationMatrix();
  const Vec3d origin = map_from_scan * scan.origin;
  for (const Vec3f& point : scan.points) {
    const Vec3d in_map = origin + rotation * point.cast<double>();
    const Vec3d cell = (in_map / options_.voxel_size).array().floor();
    if (!(cell.cwiseAbs().maxCoeff() < kMaxIndex)) continue;
    Sums& sums = sums_at(
        {static_cast<std::int32_t>(cell[0]), static_cast<std::int32_t>(cell[1]), static_cast<std::int32_t>(cell[2])});
    if (sums.count >= options_.max_count) {
      const double kept = (options_.max_count - 1.0) / sums.count;
      sums.count *= kept, sums.sum *= kept, sums.outer *= kept;
    }
    const Vec3d offset = in_map - sums.centre;
    sums.count += 1.0;
    sums.sum += offset;
    sums.outer += offset * offset.transpose();
    if (sums.last_scan != num_scans_) ++sums.num_scans, sums.last_scan = num_scans_;
  }
  ++num_scans_;
}

void SurfaceMap::forget_beyond(const Vec3d& centre_in_map, double distance) {
  std::vector<Voxel> kept;
  for (const Voxel& voxel : voxels_)
    if ((voxel.sums.centre - centre_in_map).norm() <= distance) kept.push_back(voxel);
  if (kept.size() == voxels_.size()) return;
  voxels_ = std::move(kept);
  place_.clear();
  for (std::uint32_t i = 0; i < voxels_.size(); ++i) place_.emplace(key_of(voxels_[i].index), i);
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
  for (const Sums& sums : level.sums) level.shapes.push_back(shape_of(sums));
  return level;
}

Shape SurfaceMap::shape_in(const Voxel& voxel, const std::vector<Level>& coarser, Vec3d& mean) const {
  const Shape own = shape_of(voxel.sums);
  const Vec3d own_mean = voxel.sums.centre + voxel.sums.sum / voxel.sums.count;
  mean = own_mean;
  if (own.structure != Structure::None || voxel.sums.count >= options_.thresholds.min_points) return own;
  for (const Level& level : coarser) {
    Index index = voxel.index;
    for (std::int32_t& i : index) i = floor_divided(i, level.factor);
    const std::uint32_t at = level.place.at(key_of(index));
    const Shape& shape = level.shapes[at];
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

Cloud SurfaceMap::surfaces(const Vec3d& origin_in_map) const {
  Cloud cloud;
  cloud.origin = origin_in_map;
  std::vector<Level> coarser;
  for (const int factor : kCoarser) coarser.push_back(coarser_level(factor));
  for (const Voxel& voxel : voxels_) {
    Vec3d mean;
    const Shape shape = shape_in(voxel, coarser, mean);
    if (shape.structure == Structure::None) continue;
    cloud.points.push_back((mean - origin_in_map).cast<float>());
    cloud.directions.push_back(shape.direction.cast<float>());
    cloud.structures.push_back(shape.structure);
  }
  return cloud;
}

void SurfaceMap::describe(Cloud& cloud, const Rigid3& map_from_cloud) const {
  std::vector<Shape> shapes;
  shapes.reserve(voxels_.size());
  for (const Voxel& voxel : voxels_) shapes.push_back(shape_of(voxel.sums));
  cloud.directions.assign(cloud.size(), Vec3f::Zero());
  cloud.structures.assign(cloud.size(), Structure::None);
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    const Vec3d cell =
        ((map_from_cloud * (cloud.origin + cloud.points[i].cast<double>())) / options_.voxel_size).array().floor();
    if (!(cell.cwiseAbs().maxCoeff() < kMaxIndex)) continue;
    const auto found = place_.find(key_of(
        {static_cast<std::int32_t>(cell[0]), static_cast<std::int32_t>(cell[1]), static_cast<std::int32_t>(cell[2])}));
    if (found == place_.end() || shapes[found->second].structure == Structure::None) continue;
    const Shape& shape = shapes[found->second];
    cloud.structures[i] = shape.structure;
    cloud.directions[i] = (map_from_cloud.rotation.conjugate() * shape.direction).cast<float>();
  }
}

}  // namespace augicp
