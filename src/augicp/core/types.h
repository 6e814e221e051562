// SPDX-License-Identifier: MIT
// Fixed-size aliases. Stored data is float, poses and sums are double.
#pragma once

#include <Eigen/Core>

namespace augicp {

using Vec3f = Eigen::Vector3f;
using Vec3d = Eigen::Vector3d;
using Vec6d = Eigen::Matrix<double, 6, 1>;
using Mat3d = Eigen::Matrix3d;
using Mat4d = Eigen::Matrix4d;
using Mat6d = Eigen::Matrix<double, 6, 6>;

}  // namespace augicp
