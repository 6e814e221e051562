// SPDX-License-Identifier: MIT
#include "augicp/cloud/cloud.h"

namespace augicp {

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
  Bounds box{cloud.points.front(), cloud.points.front()};
  for (const Vec3f& point : cloud.points) {
    box.min = box.min.cwiseMin(point);
    box.max = box.max.cwiseMax(point);
  }
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
