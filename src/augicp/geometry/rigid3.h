// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Geometry>

#include "augicp/core/types.h"

namespace augicp {

// A rigid motion. b_from_a maps coordinates in frame a to frame b: x_in_b = b_from_a * x_in_a. The rotation is a unit
// quaternion; every function here preserves this. Translation in metres.
struct Rigid3 {
  Eigen::Quaterniond rotation = Eigen::Quaterniond::Identity();
  Vec3d translation = Vec3d::Zero();

  Mat4d matrix() const;
};

// The same motion in float, as a matrix: for many points whose last digits do not matter.
struct Rigid3f {
  Eigen::Matrix3f rotation;
  Vec3f translation;

  explicit Rigid3f(const Rigid3& b_from_a)
      : rotation(b_from_a.rotation.toRotationMatrix().cast<float>()), translation(b_from_a.translation.cast<float>()) {}

  Vec3f operator*(const Vec3f& x_in_a) const { return rotation * x_in_a + translation; }
};

// Eq. (4): the affine part of an extended point is rotated and translated. (The linear part, Eq. (7), is only rotated.)
Vec3d operator*(const Rigid3& b_from_a, const Vec3d& x_in_a);

// c_from_a = c_from_b * b_from_a.
Rigid3 operator*(const Rigid3& c_from_b, const Rigid3& b_from_a);

// a_from_b.
Rigid3 inverse(const Rigid3& b_from_a);

// The rigid motion of a homogeneous matrix. Throws std::invalid_argument unless the matrix is finite, its last row is
// (0 0 0 1), its determinant is positive, and its rotation part is orthonormal to within tolerance. Files may have as
// few as four digits, so the result is the nearest rotation.
Rigid3 rigid3_from_matrix(const Mat4d& matrix, double tolerance = 1e-3);

// Moves a pose by an increment: translation first, rotation vector second, applied on the left, that is, in the target
// frame: (t, exp(r)) * pose. This is the only place that fixes the convention.
Rigid3 retract(const Rigid3& pose, const Vec6d& increment);

// The increment with retract(from, result) = to.
Vec6d increment_between(const Rigid3& from, const Rigid3& to);

// The angle between the rotations of two poses, radians in [0, pi].
double angle_between(const Rigid3& a, const Rigid3& b);

}  // namespace augicp
