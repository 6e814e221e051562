// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "augicp/match/matcher.h"
#include "augicp/objective/linearize.h"

namespace augicp {

// Where the loop ended, and by what: the pairs under the final pose, the gates that they were found within, and the
// objective that was minimised over them.
struct Solution {
  PosedPairs posed;
  Gates gates;
  Objective objective;
};

// The covariance of the increment (tx ty tz rx ry rz, on the left, about the target points' zero) that the pairs'
// errors leave at the minimum, from the errors themselves:
//
//   A^-1 M A^-1,  M = G / (G - 6) * sum over cells of g g^T,  g: gradient of the cell's pairs, G: their number
//
// the cluster-robust "sandwich" (White 1980; Liang and Zeger 1986). It needs no model of the noise, for what is seen is
// taken, and none of its correlation but a length: errors of points in one cell may hang together in any way, those of
// different cells may not. A is how the gradient changes with the pose when the pairs do too: H takes the pairs as
// fixed, and so as holding the clouds along their surfaces too, which pairs that are found anew do not. directions: see
// Observability. Absent where the pose is no minimum in this sense, or cells are too few. Not for degenerate problems.
std::optional<Mat6d> covariance(const Matcher& matcher, const Solution& solution, double correlation_length,
                                const Mat6d& directions, int num_threads);

}  // namespace augicp
