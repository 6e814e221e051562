// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "augicp/match/matcher.h"
#include "augicp/objective/linearize.h"

namespace augicp {

// The end of the loop: the pairs under the final pose, their gates, and the objective that was minimised over them.
struct Solution {
  PosedPairs posed;
  Gates gates;
  Objective objective;
};

// The covariance of the increment (tx ty tz rx ry rz, on the left, about the target points' zero) at the minimum, from
// the residuals of the pairs:
//
//   A^-1 M A^-1,  M = G / (G - 6) * sum over cells of g g^T,  g: gradient of the cell's pairs, G: number of cells
//
// This is the cluster-robust "sandwich" (White 1980; Liang and Zeger 1986). It needs no model of the noise, and of its
// correlation only a length: residuals of points in one cell may be correlated in any way, those in different cells may
// not. A is the change of the gradient with the pose when the pairs change too. H keeps the pairs fixed, so it
// constrains the clouds along their surfaces, which repeated searches do not.
//
// directions: see Observability. Empty if the pose is no minimum in this sense, or if there are too few cells.
// REQUIRES: the problem is not degenerate.
std::optional<Mat6d> covariance(const Matcher& matcher, const Solution& solution, double correlation_length,
                                const Mat6d& directions, int num_threads);

// The same covariance for increments that rotate about another point: `offset`, metres, leads there from the point
// about which those of `covariance` rotate. A translation is that of the point: t' = t + r x offset. Far from the
// points, translations are mostly rotations seen from afar; near their centre both are what they seem.
Mat6d covariance_about(const Mat6d& covariance, const Vec3d& offset);

// The RMS distance by which increments of this covariance, about the points' zero, move the points of a cloud, metres.
// 0 for an empty cloud.
double rms_motion(const Mat6d& covariance, const Cloud& cloud);

}  // namespace augicp
