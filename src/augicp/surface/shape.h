// SPDX-License-Identifier: MIT
// From sums over a neighbourhood to the structure of a point (section 4.1): numbers in, numbers out.
#pragma once

#include <cmath>

#include "augicp/cloud/cloud.h"
#include "augicp/core/types.h"

namespace augicp {

// The Gaussian of some points, Eq. (15).
struct Gaussian {
  double count = 0.0;
  Vec3d mean = Vec3d::Zero();
  Mat3d covariance = Mat3d::Zero();
};

// Eigenvalues in ascending order, eigenvectors as columns in the same order.
struct Eigen3 {
  Vec3d values = Vec3d::Zero();
  Mat3d vectors = Mat3d::Identity();
};
Eigen3 eigen_of_symmetric(const Mat3d& matrix);

struct ShapeThresholds {
  // A neighbourhood with fewer points has no structure.
  double min_points = 8.0;

  // l0 / (l0 + l1 + l2) of the points. Below: a plane. The authors' program uses 0.02.
  double max_planar_curvature = 0.02;

  // l1 / l2 of the points. Below: a line (a wire, the rim of a thin board).
  double max_line_ratio = 0.1;

  // A line within this angle of the line of sight is no wire, but a part of a steep surface. Radians.
  double min_line_to_sight = 0.45;

  // l0 / l1 of the points. Above: as thick as wide (a tangle, or noise larger than the ball), so no normal. A
  // right-angle crease through the middle has 0.28.
  double max_thickness = 0.5;

  // NormalSpread::across. Above clear_crease: a crease. Above min_crease with a clear crease in the neighbourhood: a
  // point of that crease; without one, a curved surface. A right-angle crease has 0.2 in its middle and 0.03 one radius
  // away. A cylinder of three times the ball radius has 0.03 everywhere.
  double min_crease = 0.035;
  double clear_crease = 0.1;

  // Smallest eigenvalue of the mean outer product of the normals around. Above: they point three ways, as in a corner.
  double max_corner = 0.02;
};

// The rules for eigenvalues l0 <= l1 <= l2, for double and float.
template <typename Number>
bool is_line(Number l1, Number l2, const ShapeThresholds& thresholds) {
  return l1 < static_cast<Number>(thresholds.max_line_ratio) * l2;
}
template <typename Number>
bool is_thick(Number l0, Number l1, const ShapeThresholds& thresholds) {
  return l0 > static_cast<Number>(thresholds.max_thickness) * l1;
}
template <typename Number>
Structure structure_of_points(Number l0, Number l1, Number l2, const ShapeThresholds& thresholds) {
  const bool flat = l0 < static_cast<Number>(thresholds.max_planar_curvature) * (l0 + l1 + l2);
  if (flat && !is_line(l1, l2, thresholds)) return Structure::Planar;
  // "One eigenvalue smaller than the other two" covers the wire, with two small beside l2, and the right-angle crease
  // (0.035, 0.125, 0.25). A corner has three similar ones. Half way between crease and corner, l1 / l2 is 3/4.
  return l1 < static_cast<Number>(0.75) * l2 ? Structure::Edge : Structure::None;
}

// The paper's rule: from the eigenvalues of the points alone. Directions are eigenvectors.
struct Shape {
  Structure structure = Structure::None;
  Vec3d direction = Vec3d::Zero();
};
Shape shape_of_points(const Gaussian& points, const Eigen3& eigen, const ShapeThresholds& thresholds);

// Whether a line (a unit vector) is too close to the line of sight to be trusted; false if the line of sight is unknown
// (zero).
inline bool is_along(const Vec3d& line, const Vec3d& line_of_sight, const ShapeThresholds& thresholds) {
  return std::abs(line.dot(line_of_sight)) > std::cos(thresholds.min_line_to_sight);
}

// Our rule, in three steps over the same neighbourhood.
//
// First, the points give a line, a normal, or neither. The line of sight is a unit vector; zero if it is unknown.
Shape line_or_normal(const Gaussian& points, const Eigen3& eigen, const Vec3d& line_of_sight,
                     const ShapeThresholds& thresholds);

// Orients the normal of a point towards the viewpoint.
inline void point_towards(const Vec3f& viewpoint, const Vec3f& point, Vec3f& normal) {
  if (normal.dot(viewpoint - point) < 0.0f) normal = -normal;
}

// Second, the normals around a point. At a crease all are orthogonal to its tangent. `across` measures their spread
// around the tangent; `along` their spread along it, as in a corner.
struct NormalSpread {
  Vec3d tangent = Vec3d::Zero();
  double across = 0.0;  // second and third eigenvalue of the mean outer product of the normals
  double along = 0.0;
};
NormalSpread spread_of_normals(const Eigen3& of_mean_outer_normal);

}  // namespace augicp
