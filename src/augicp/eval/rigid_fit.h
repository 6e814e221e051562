// SPDX-License-Identifier: MIT
// The motion between two sets of points whose pairs are known, by least squares: S. Umeyama, "Least-Squares Estimation
// of Transformation Parameters Between Two Point Patterns", PAMI 13(4), 1991.
#pragma once

#include <span>

#include "augicp/geometry/rigid3.h"

namespace augicp {

// A rigid motion after a change of scale: x_in_b = motion * (scale * x_in_a).
struct Similarity3 {
  double scale = 1.0;
  Rigid3 motion;
};

Vec3d operator*(const Similarity3& b_from_a, const Vec3d& x_in_a);

// The pose of a body, a_from_body, in frame b: its position is scaled, its orientation only rotated.
Rigid3 operator*(const Similarity3& b_from_a, const Rigid3& a_from_body);

struct RigidFit {
  Similarity3 target_from_source;
  // False if several rotations fit as well as the best: fewer than three points, a set that stands still, all points of
  // a set on a line (to within a millionth of its length, or to within the residual of the fit), or a mirrored set with
  // a symmetry. The sum of squares is still the least. For points on a line the rotation is the smallest of the best
  // ones, without a rotation about the line; for equal points it is none.
  bool unique = true;
};

// Minimises sum |target_i - target_from_source * source_i|^2. Never returns a reflection. Throws std::invalid_argument
// for no points, unequal counts, and coordinates that are not finite or whose squares overflow.
RigidFit fit_rigid(std::span<const Vec3d> source, std::span<const Vec3d> target);

// The same, with the best scale, which is at least 0; 1 if all source points are equal.
RigidFit fit_similarity(std::span<const Vec3d> source, std::span<const Vec3d> target);

}  // namespace augicp
