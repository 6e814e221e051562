// SPDX-License-Identifier: MIT
// Sums over a neighbourhood, and the Gaussians made of them, Eq. (15).
#pragma once

#include "augicp/surface/neighbourhood.h"
#include "augicp/surface/shape.h"

namespace augicp {

// The upper triangle of a symmetric matrix as six numbers, row by row, and back.
void pack(const Mat3d& m, Eigen::Ref<Eigen::Array<double, 6, 1>> packed);
Mat3d unpack(const Eigen::Ref<const Eigen::Array<double, 6, 1>>& packed);

// Count, sum and sum of outer products of each point: the moments in Eq. (15), ten rows.
Channels point_moments(const Cloud& cloud);

// The Gaussian of summed point moments. REQUIRES: the count is above 0.
Gaussian gaussian_of(const Eigen::Ref<const Eigen::ArrayXd>& moments);

}  // namespace augicp
