// SPDX-License-Identifier: MIT
#include "augicp/surface/shape.h"

#include <Eigen/Eigenvalues>
#include <cmath>

namespace augicp {

Eigen3 eigen_of_symmetric(const Mat3d& matrix) {
  const Eigen::SelfAdjointEigenSolver<Mat3d> solver(matrix);
  // Rounding may leave the smallest eigenvalue of points on a plane just below zero.
  return {solver.eigenvalues().cwiseMax(0.0), solver.eigenvectors()};
}

Shape shape_of_points(const Gaussian& points, const Eigen3& eigen, const ShapeThresholds& thresholds) {
  const Vec3d& l = eigen.values;
  if (points.count < thresholds.min_points || !(l[2] > 0.0)) return {};
  if (l[0] < thresholds.max_planar_curvature * l.sum() && l[1] >= thresholds.max_line_ratio * l[2])
    return {Structure::Planar, eigen.vectors.col(0)};
  // "One eigenvalue smaller than the other two" covers both the wire, where two are small beside l2, and the
  // right-angle crease (0.035, 0.125, 0.25); a corner has all three alike. Half way between crease and corner, l1 / l2
  // is 3/4.
  if (l[1] < 0.75 * l[2]) return {Structure::Edge, eigen.vectors.col(2)};
  return {};
}

Shape line_or_normal(const Gaussian& points, const Eigen3& eigen, const Vec3d& line_of_sight,
                     const ShapeThresholds& thresholds) {
  const Vec3d& l = eigen.values;
  if (points.count < thresholds.min_points || !(l[2] > 0.0)) return {};
  const bool along_sight = std::abs(eigen.vectors.col(2).dot(line_of_sight)) > std::cos(thresholds.min_line_to_sight);
  if (l[1] < thresholds.max_line_ratio * l[2] && !along_sight) return {Structure::Edge, eigen.vectors.col(2)};
  if (l[0] > thresholds.max_thickness * l[1]) return {};
  return {Structure::Planar, eigen.vectors.col(0)};
}

NormalSpread spread_of_normals(const Mat3d& mean_outer_normal) {
  const Eigen3 eigen = eigen_of_symmetric(mean_outer_normal);
  return {eigen.vectors.col(0), eigen.values[1], eigen.values[0]};
}

}  // namespace augicp
