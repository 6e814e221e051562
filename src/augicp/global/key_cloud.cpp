// SPDX-License-Identifier: MIT
#include "augicp/global/key_cloud.h"

#include <algorithm>
#include <cmath>

#include "augicp/cloud/voxel_grid.h"
#include "augicp/core/parallel.h"
#include "augicp/surface/shape.h"

namespace augicp {
namespace {

constexpr double kNormalVoxels = 2.5;  // radius of the ball of a normal
constexpr double kMinPoints = 5.0;

// Below, the points lie on a line: a plane about it has any normal.
constexpr double kMinPlaneRatio = 0.02;

constexpr int kMaxRounds = 6;
constexpr std::size_t kKeysPerBlock = 256;

// Sums over offsets from a point.
struct Moments {
  double count = 0.0;
  Vec3d sum = Vec3d::Zero(), squares = Vec3d::Zero(), products = Vec3d::Zero();  // products: xy, xz, yz

  void add(const Vec3d& d) {
    count += 1.0;
    sum += d;
    squares += d.cwiseProduct(d);
    products += Vec3d(d.x() * d.y(), d.x() * d.z(), d.y() * d.z());
  }

  Gaussian gaussian() const {
    Gaussian of;
    of.count = count;
    of.mean = sum / count;
    Mat3d outer;
    outer << squares.x(), products.x(), products.y(), products.x(), squares.y(), products.z(), products.y(),
        products.z(), squares.z();
    of.covariance = outer / count - of.mean * of.mean.transpose();
    return of;
  }
};

// Of the ball of the normal, and of that of the descriptor.
struct TwoBalls {
  Moments small, large;
};
TwoBalls moments_around(const KeyCloud& keys, std::size_t i) {
  const auto squared = [](double radius) { return static_cast<float>(radius * radius); };
  const float small_sq = squared(kNormalVoxels * keys.voxel_size);
  TwoBalls sums;
  for (const std::uint32_t j : keys.balls.around(i)) {
    const Vec3f offset = keys.points[j] - keys.points[i];
    const Vec3d d = offset.cast<double>();
    sums.large.add(d);
    if (offset.squaredNorm() <= small_sq) sums.small.add(d);
  }
  return sums;
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
  keys.balls = BallLists(keys.points, keys.points, kBallVoxels * voxel_size, num_threads);
  const auto estimate = [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const TwoBalls around = moments_around(keys, i);
      keys.normals[i] = normal_of(around.small.gaussian());
      if (viewpoint) point_towards(*viewpoint, keys.points[i], keys.normals[i]);
      keys.variation[i] = variation_of(around.large.gaussian());
    }
  };
  for_each_block(keys.size(), num_threads, estimate, kKeysPerBlock);
  return keys;
}

}  // namespace augicp
