// SPDX-License-Identifier: MIT
// Rotations as unit quaternions, and their increments as rotation vectors (axis times angle, radians).
#pragma once

#include <Eigen/Geometry>

#include "augicp/core/types.h"

namespace augicp {

// The rotation by |rotation_vector| radians about its axis. Exact at zero and for tiny angles.
Eigen::Quaterniond rotation_exp(const Vec3d& rotation_vector);

// The shortest rotation vector of a unit quaternion, |result| in [0, pi].
Vec3d rotation_log(const Eigen::Quaterniond& rotation);

// The matrix with cross_matrix(a) * b = a x b.
Mat3d cross_matrix(const Vec3d& a);

}  // namespace augicp
