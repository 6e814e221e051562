// SPDX-License-Identifier: MIT
// Eigenvalues and eigenvectors of many symmetric 3 x 3 matrices at once, in closed form and in double. Elements are
// arrays with one entry per matrix, so that compilers vectorise.
#pragma once

#include <cstddef>
#include <span>

#include "augicp/surface/shape.h"

namespace augicp {

inline constexpr std::size_t kEigenBatch = 32;

// eigen_of_symmetric() of each matrix, at most kEigenBatch, to ten digits of the largest eigenvalue; an eighth of the
// time. Matrices with two eigenvalues closer than a thousandth of the sum are solved one by one. REQUIRES: positive
// semidefinite matrices, and room for all results.
void eigen_of_symmetric(std::span<const Mat3d> matrices, std::span<Eigen3> solved);

}  // namespace augicp
