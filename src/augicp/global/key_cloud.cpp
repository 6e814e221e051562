// SPDX-License-Identifier: MIT
#include "augicp/global/key_cloud.h"

#include <algorithm>
#include <cmath>

#include "augicp/cloud/voxel_grid.h"
#include "augicp/core/parallel.h"
#include "augicp/surface/shape.h"

namespace augicp {
namespace {

constexpr double kNormalVoxels = 2.5;     // radius of the ball of a normal
constexpr double kVariationVoxels = 5.0;  // as of the smaller descriptor
constexpr double kMinPoints = 5.0;

// Below, the points lie on a line: a plane about it has any normal.
constexpr double kMinPlaneRatio = 0.02;

constexpr int kMaxRounds = 6;
constexpr std::size_t kPointsPerBlock = 256;

Gaussian gaussian_around(const std::vector<Vec3f>& points, std::span<const std::uint32_t> near, const Vec3f& centre,
                         double radius) {
  Gaussian sum;
  const auto radius_sq = static_cast<float>(radius * radius);
  for (const std::uint32_t j : near) {
    const Vec3f offset = points[j] - centre;
    if (offset.squaredNorm() > radius_sq) continue;
    const Vec3d d = offset.cast<double>();
    sum.count += 1.0;
    sum.mean += d;
    sum.covariance += d * d.transpose();
  }
  sum.mean /= sum.count;
  sum.covariance = sum.covariance / sum.count - sum.mean * sum.mean.transpose();
  return sum;
}

Vec3f normal_of(const Gaussian& near) {
  if (near.count < kMinPoints) return Vec3f::Zero();
  const Eigen3 eigen = eigen_of_symmetric(near.covariance);
  if (!(eigen.values[1] > kMinPlaneRatio * eigen.values[2])) return Vec3f::Zero();
  return eigen.vectors.col(0).cast<float>();
}

float variation_of(const Gaussian& near) {
  const Eigen3 eigen = eigen_of_symmetric(near.covariance);
  const double sum = eigen.values.sum();
  return sum > 0.0 ? static_cast<float>(std::max(0.0, eigen.values[0]) / sum) : 0.0f;
}

}  // namespace

double common_voxel(const Cloud& source, const Cloud& target, double least_voxel_size, std::size_t max_points) {
  double voxel_size = least_voxel_size;
  for (int round = 0; round < kMaxRounds; ++round) {
    const std::size_t count = std::max(count_voxels(source, voxel_size), count_voxels(target, voxel_size));
    if (count <= max_points) break;
    // Points on surfaces, with a little more than that asks for.
    voxel_size *= std::max(1.05, 1.02 * std::sqrt(static_cast<double>(count) / static_cast<double>(max_points)));
  }
  return voxel_size;
}

KeyCloud key_cloud(const Cloud& cloud, double voxel_size, const std::optional<Vec3f>& viewpoint, int num_threads) {
  KeyCloud keys;
  keys.points = downsample(cloud, voxel_size).points;
  keys.voxel_size = voxel_size;
  keys.viewpoint = viewpoint;
  keys.normals.resize(keys.size());
  keys.variation.resize(keys.size());
  const BallLists balls(keys.points, keys.points, kVariationVoxels * voxel_size, num_threads);
  const auto estimate = [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const auto near = balls.around(i);
      const Vec3f& point = keys.points[i];
      keys.normals[i] = normal_of(gaussian_around(keys.points, near, point, kNormalVoxels * voxel_size));
      if (viewpoint) point_towards(*viewpoint, point, keys.normals[i]);
      keys.variation[i] = variation_of(gaussian_around(keys.points, near, point, kVariationVoxels * voxel_size));
    }
  };
  for_each_block(keys.size(), num_threads, estimate, kPointsPerBlock);
  return keys;
}

}  // namespace augicp
