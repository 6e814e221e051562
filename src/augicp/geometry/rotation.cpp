// SPDX-License-Identifier: MIT
#include "augicp/geometry/rotation.h"

#include <cmath>

namespace augicp {

Eigen::Quaterniond rotation_exp(const Vec3d& rotation_vector) {
  const double half_angle = 0.5 * rotation_vector.norm();
  // Series of sin(x) / x for arguments for which the quotient loses digits; the next term is below 1e-17.
  const double sinc = half_angle < 1e-4 ? 1.0 - half_angle * half_angle / 6.0 : std::sin(half_angle) / half_angle;
  const Vec3d imaginary = 0.5 * sinc * rotation_vector;
  return Eigen::Quaterniond(std::cos(half_angle), imaginary.x(), imaginary.y(), imaginary.z()).normalized();
}

Vec3d rotation_log(const Eigen::Quaterniond& rotation) {
  // q and -q are the same rotation. The one with w >= 0 has an angle of at most pi.
  const double sign = rotation.w() < 0.0 ? -1.0 : 1.0;
  const Vec3d imaginary = sign * rotation.vec();
  const double sine = imaginary.norm();
  const double half_angle = std::atan2(sine, sign * rotation.w());
  return (sine < 1e-8 ? 2.0 : 2.0 * half_angle / sine) * imaginary;
}

Mat3d cross_matrix(const Vec3d& a) {
  Mat3d m;
  m << 0.0, -a.z(), a.y(), a.z(), 0.0, -a.x(), -a.y(), a.x(), 0.0;
  return m;
}

}  // namespace augicp
