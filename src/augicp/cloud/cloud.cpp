// SPDX-License-Identifier: MIT
#include "augicp/cloud/cloud.h"

#include "augicp/core/vectorized.h"

namespace augicp {
namespace {

// Coordinates of whole points, and whole vectors of 16.
constexpr std::size_t kFloatLanes = 48;
static_assert(sizeof(Vec3f) == 3 * sizeof(float));  // the coordinates of points are contiguous

// REQUIRES: count is a multiple of kFloatLanes.
AUGICP_VECTORIZED void widen(const float* __restrict coordinates, std::size_t count, float* __restrict min,
                             float* __restrict max) {
  for (std::size_t first = 0; first < count; first += kFloatLanes)
    for (std::size_t lane = 0; lane < kFloatLanes; ++lane) {
      const float x = coordinates[first + lane];
      min[lane] = x < min[lane] ? x : min[lane];
      max[lane] = x > max[lane] ? x : max[lane];
    }
}

}  // namespace

PointGaussian operator*(const Rigid3f& b_from_a, const PointGaussian& gaussian_in_a) {
  return {b_from_a * gaussian_in_a.mean, b_from_a.rotation * gaussian_in_a.information * b_from_a.rotation.transpose()};
}

Cloud transform(const Cloud& cloud_in_a, const Rigid3& b_from_a) {
  const Rigid3f about_origin({b_from_a.rotation, Vec3d::Zero()});
  const Eigen::Matrix3f& rotation = about_origin.rotation;
  Cloud moved = cloud_in_a;
  moved.origin = b_from_a * cloud_in_a.origin;
  for (Vec3f& point : moved.points) point = rotation * point;
  for (Vec3f& direction : moved.directions) direction = rotation * direction;
  for (Vec3f& gradient : moved.intensity_gradients) gradient = rotation * gradient;
  for (PointGaussian& gaussian : moved.gaussians) gaussian = about_origin * gaussian;
  if (moved.viewpoint) moved.viewpoint = rotation * *moved.viewpoint;
  return moved;
}

Bounds bounds(const Cloud& cloud) {
  if (cloud.empty()) return {};
  const float* const first = cloud.points.front().data();
  float min[kFloatLanes], max[kFloatLanes];
  for (std::size_t lane = 0; lane < kFloatLanes; ++lane) min[lane] = max[lane] = first[lane % 3];
  const std::size_t num_floats = 3 * cloud.size(), num_in_lanes = num_floats / kFloatLanes * kFloatLanes;
  widen(first, num_in_lanes, min, max);
  Bounds box{cloud.points.front(), cloud.points.front()};
  const auto add = [&](std::size_t axis, float low, float high) {
    if (low < box.min[axis]) box.min[axis] = low;
    if (high > box.max[axis]) box.max[axis] = high;
  };
  for (std::size_t lane = 0; lane < kFloatLanes; ++lane) add(lane % 3, min[lane], max[lane]);
  for (std::size_t k = num_in_lanes; k < num_floats; ++k) add(k % 3, first[k], first[k]);
  return box;
}

Rigid3 with_origins(const Rigid3& target_points_from_source_points, const Cloud& source, const Cloud& target) {
  Rigid3 pose = target_points_from_source_points;
  pose.translation += target.origin - pose.rotation * source.origin;
  return pose;
}

Rigid3 without_origins(const Rigid3& target_from_source, const Cloud& source, const Cloud& target) {
  Rigid3 pose = target_from_source;
  pose.translation -= target.origin - pose.rotation * source.origin;
  return pose;
}

}  // namespace augicp
