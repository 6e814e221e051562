// SPDX-License-Identifier: MIT
#include "augicp/geometry/rigid3.h"

#include <Eigen/SVD>
#include <stdexcept>

#include "augicp/geometry/rotation.h"

namespace augicp {

Mat4d Rigid3::matrix() const {
  Mat4d m = Mat4d::Identity();
  m.topLeftCorner<3, 3>() = rotation.toRotationMatrix();
  m.topRightCorner<3, 1>() = translation;
  return m;
}

Vec3d operator*(const Rigid3& b_from_a, const Vec3d& x_in_a) {
  return b_from_a.rotation * x_in_a + b_from_a.translation;
}

Rigid3 operator*(const Rigid3& c_from_b, const Rigid3& b_from_a) {
  // Normalised, so that a long chain of products remains a rotation.
  return {(c_from_b.rotation * b_from_a.rotation).normalized(), c_from_b * b_from_a.translation};
}

Rigid3 inverse(const Rigid3& b_from_a) {
  const Eigen::Quaterniond rotation = b_from_a.rotation.conjugate();
  return {rotation, -(rotation * b_from_a.translation)};
}

Rigid3 rigid3_from_matrix(const Mat4d& matrix, double tolerance) {
  if (!matrix.allFinite()) throw std::invalid_argument("transform: has entries that are not finite");
  if ((matrix.row(3) - Eigen::RowVector4d(0, 0, 0, 1)).cwiseAbs().maxCoeff() > tolerance)
    throw std::invalid_argument("transform: last row must be 0 0 0 1");
  const Mat3d linear = matrix.topLeftCorner<3, 3>();
  if ((linear.transpose() * linear - Mat3d::Identity()).cwiseAbs().maxCoeff() > tolerance)
    throw std::invalid_argument("transform: not a rigid motion, its rotation part is not orthonormal");
  if (linear.determinant() < 0.0) throw std::invalid_argument("transform: not a rigid motion, it is a reflection");
  const Eigen::JacobiSVD<Mat3d> svd(linear, Eigen::ComputeFullU | Eigen::ComputeFullV);
  const Mat3d nearest_rotation = svd.matrixU() * svd.matrixV().transpose();
  return {Eigen::Quaterniond(nearest_rotation).normalized(), matrix.topRightCorner<3, 1>()};
}

Rigid3 retract(const Rigid3& pose, const Vec6d& increment) {
  return Rigid3{rotation_exp(increment.tail<3>()), increment.head<3>()} * pose;
}

Vec6d increment_between(const Rigid3& from, const Rigid3& to) {
  const Rigid3 step = to * inverse(from);
  Vec6d increment;
  increment << step.translation, rotation_log(step.rotation);
  return increment;
}

double angle_between(const Rigid3& a, const Rigid3& b) {
  return rotation_log(a.rotation.conjugate() * b.rotation).norm();
}

}  // namespace augicp
