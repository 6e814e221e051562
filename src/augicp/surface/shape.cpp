// SPDX-License-Identifier: MIT
#include "augicp/surface/shape.h"

#include <Eigen/Eigenvalues>
#include <cmath>

namespace augicp {

Eigen3 eigen_of_symmetric(const Mat3d& matrix) {
  Eigen::SelfAdjointEigenSolver<Mat3d> solver;
  solver.computeDirect(matrix);  // closed form, to eight digits: a fifth less time for surfaces of clouds
  // Rounding may give points on a plane a smallest eigenvalue slightly below zero.
  return {solver.eigenvalues().cwiseMax(0.0), solver.eigenvectors()};
}

Shape shape_of_points(const Gaussian& points, const Eigen3& eigen, const ShapeThresholds& thresholds) {
  const Vec3d& l = eigen.values;
  if (points.count < thresholds.min_points || !(l[2] > 0.0)) return {};
  const Structure structure = structure_of_points(l[0], l[1], l[2], thresholds);
  if (structure == Structure::None) return {};
  return {structure, eigen.vectors.col(structure == Structure::Planar ? 0 : 2)};
}

Shape line_or_normal(const Gaussian& points, const Eigen3& eigen, const Vec3d& line_of_sight,
                     const ShapeThresholds& thresholds) {
  const Vec3d& l = eigen.values;
  if (points.count < thresholds.min_points || !(l[2] > 0.0)) return {};
  const Vec3d line = eigen.vectors.col(2);
  if (is_line(l[1], l[2], thresholds) && !is_along(line, line_of_sight, thresholds)) return {Structure::Edge, line};
  if (is_thick(l[0], l[1], thresholds)) return {};
  return {Structure::Planar, eigen.vectors.col(0)};
}

NormalSpread spread_of_normals(const Eigen3& of_mean_outer_normal) {
  return {of_mean_outer_normal.vectors.col(0), of_mean_outer_normal.values[1], of_mean_outer_normal.values[0]};
}

}  // namespace augicp
