// SPDX-License-Identifier: MIT
// From sums over a neighbourhood to the structure of a point (section 4.1): plain numbers in, plain numbers out.
#pragma once

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
  // Fewer points say nothing about a surface.
  double min_points = 8.0;

  // l0 / (l0 + l1 + l2) of the points: below, they lie on a plane. The authors' program uses 0.02.
  double max_planar_curvature = 0.02;

  // l1 / l2 of the points: below, they lie on a line (a wire, the rim of a thin board).
  double max_line_ratio = 0.1;

  // Of the normals around a point, as shares of 1: where the second eigenvalue of their mean outer product is above
  // min_crease they point two ways, as around a crease; where the third is above min_corner, three ways.
  double min_crease = 0.05;
  double max_corner = 0.02;
};

// The paper's reading: of the points' eigenvalues alone. Directions are the eigenvectors.
struct Shape {
  Structure structure = Structure::None;
  Vec3d direction = Vec3d::Zero();
};
Shape shape_of_points(const Gaussian& points, const Eigen3& eigen, const ShapeThresholds& thresholds);

// Ours: the points say what is a line and give the normals; the normals around a point say whether it lies on one
// surface, on a crease, whose tangent every normal is orthogonal to, or in a corner. A crease is so found and its
// tangent known even far from the middle of the ball, where the points' own second and third eigenvalue are alike.
Shape shape_of_normals(const Shape& of_points, const Mat3d& mean_outer_normal, const ShapeThresholds& thresholds);

}  // namespace augicp
