// SPDX-License-Identifier: MIT
#pragma once

#include <span>

#include "augicp/objective/linearize.h"

namespace augicp {

// The covariance of the increment (tx ty tz rx ry rz, on the left, about the target points' zero) that the pairs' errors
// leave at the minimum, from the errors themselves:
//
//   A^-1 M A^-1,  M = G / (G - 6) * sum over cells of g g^T,  g: gradient of the cell's pairs, G: their number
//
// the cluster-robust "sandwich" (White 1980; Liang and Zeger 1986). It needs no model of the noise, for what is seen is taken, and
// none of its correlation but a length: errors of points in one cell may hang together in any way, those of different
// cells may not. A is the curvature of the robust loss: H less twice the part of the pairs beyond the kernel, whose
// pull grows weaker the farther they lie. equations: of all the pairs, at the minimum. Zero where A cannot be inverted or there are too few cells.
Mat6d covariance(const Cloud& source, const Cloud& target, std::span<const Correspondence> pairs,
                 const Rigid3& target_from_source, const Objective& objective, const NormalEquations& equations,
                 double correlation_length);

}  // namespace augicp
