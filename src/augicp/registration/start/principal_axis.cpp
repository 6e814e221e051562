// SPDX-License-Identifier: MIT
#include "augicp/registration/start/principal_axis.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <vector>

namespace augicp {
namespace {

constexpr double kFarthest = 0.02;  // the part of the points that has no say

// Without the points farthest from the mean: outliers would pull it.
std::vector<Vec3d> without_farthest(const Cloud& cloud) {
  std::vector<Vec3d> points;
  Vec3d mean = Vec3d::Zero();
  for (const Vec3f& point : cloud.points) {
    points.push_back(point.cast<double>());
    mean += points.back();
  }
  mean /= static_cast<double>(points.size());
  const auto kept =
      points.begin() + static_cast<std::ptrdiff_t>((1.0 - kFarthest) * static_cast<double>(points.size()));
  std::nth_element(points.begin(), kept, points.end(),
                   [&](const Vec3d& a, const Vec3d& b) { return (a - mean).squaredNorm() < (b - mean).squaredNorm(); });
  points.erase(std::max(kept, points.begin() + 1), points.end());
  return points;
}

}  // namespace

RotationAxis principal_axis(const Cloud& cloud) {
  const std::vector<Vec3d> points = without_farthest(cloud);
  Vec3d mean = Vec3d::Zero();
  for (const Vec3d& point : points) mean += point;
  mean /= static_cast<double>(points.size());
  Mat3d scatter = Mat3d::Zero();
  for (const Vec3d& point : points) scatter += (point - mean) * (point - mean).transpose();
  const Eigen::SelfAdjointEigenSolver<Mat3d> solver(scatter);
  const Vec3d& moments = solver.eigenvalues();  // ascending
  const bool is_flat = moments[1] - moments[0] > moments[2] - moments[1];
  return {mean, solver.eigenvectors().col(is_flat ? 0 : 2)};
}

}  // namespace augicp
