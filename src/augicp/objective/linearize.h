// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "augicp/cloud/posed_pairs.h"
#include "augicp/objective/information.h"
#include "augicp/objective/intensity.h"

namespace augicp {

// The objective of Eq. (8) with the robust weight of Eq. (13).
struct Objective {
  InformationModel information;

  // K: a pair with a larger chi2 has the weight gamma = K / chi2. In units of chi2, above 0. Values below 1e-30 of the
  // largest information count as that.
  double kernel_chi2 = std::numeric_limits<double>::infinity();

  // The same for the direction's part alone, before it enters chi2: two directions may differ (clutter, a wrong pair)
  // although the positions fit well.
  double kernel_direction_chi2 = std::numeric_limits<double>::infinity();

  // Beyond the paper: a third part of every pair's error. Off if its information is 0.
  IntensityModel intensity{};
};

// H, b and cost over the pairs, Eq. (14). Points are without their origins. The linear part counts if both points of a
// pair have the same structure. A tangent is compared without its sign; so is a normal, unless both sensor positions
// are known. Omega is scaled by the target point's weight if it has one. REQUIRES: points are within a thousand extents
// of zero, because errors are float; points of files are. Bit-identical for any number of threads.
NormalEquations linearize(const PosedPairs& posed, const Objective& objective, int num_threads);

// b for groups of pairs, each equal to that of linearize() except for the last digits. Group g has pairs[begin[g]],
// ..., pairs[begin[g + 1] - 1]. REQUIRES: begin ascends from the begin of the first group to the end of the last, and
// has at least one entry.
std::vector<Vec6d> gradients_of_groups(const PosedPairs& posed, std::span<const std::size_t> begin,
                                       const Objective& objective, int num_threads);

// The two parts of chi2 = e^T Omega e of every pair, before the robust weight. The direction's part is negative if it
// is not compared.
struct PairChi2 {
  std::vector<float> position, direction;
};
PairChi2 chi2_of_pairs(const PosedPairs& posed, const InformationModel& information, int num_threads);

}  // namespace augicp
