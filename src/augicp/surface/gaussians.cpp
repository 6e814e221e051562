// SPDX-License-Identifier: MIT
#include "augicp/surface/gaussians.h"

#include "augicp/core/check.h"
#include "augicp/core/parallel.h"
#include "augicp/surface/moments.h"

namespace augicp {

PointGaussian relative_gaussian(const Gaussian& points, double radius) {
  PointGaussian relative{points.mean.cast<float>(), Eigen::Matrix3f::Zero()};
  const Eigen3 eigen = eigen_of_symmetric(points.covariance);
  const double largest = eigen.values[2], of_disc = 0.25 * radius * radius;
  if (points.count < ShapeThresholds{}.min_points || !(largest > 0.0)) return relative;
  const Vec3d information = of_disc * eigen.values.cwiseMax(kLeastVariance * largest).cwiseInverse();
  const Mat3d matrix = eigen.vectors * information.asDiagonal() * eigen.vectors.transpose();
  relative.information = matrix.cast<float>();
  return relative;
}

void estimate_gaussians(Cloud& cloud, const Neighbourhood& neighbourhood, double radius, int num_threads) {
  require_positive("radius", radius);
  const Channels sums = neighbourhood.sum(point_moments(cloud), num_threads);
  cloud.gaussians.resize(cloud.size());
  for_each_block(cloud.size(), num_threads, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
      cloud.gaussians[i] = relative_gaussian(gaussian_of(sums.col(static_cast<Eigen::Index>(i))), radius);
  });
}

}  // namespace augicp
