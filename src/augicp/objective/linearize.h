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

// Eq. (8) with the robust weight of Eq. (13).
struct Objective {
  InformationModel information;

  // K: a pair whose chi2 is above counts with gamma = K / chi2. In units of chi2, above 0; 1e-30 of the largest
  // information is the least.
  double kernel_chi2 = std::numeric_limits<double>::infinity();

  // The same for the direction's part alone, before it enters chi2: two directions may be unlike (clutter, a wrong
  // pair) where the positions fit well.
  double kernel_direction_chi2 = std::numeric_limits<double>::infinity();

  // Beyond the paper: a third part of every pair's error. Off where its information is 0.
  IntensityModel intensity{};
};

// H, b and cost over the pairs. Points of both clouds are taken without their origins, and should lie within a thousand
// extents of zero, as those of files do: what is made of errors is float. A linear part counts where both points of a
// pair have the same structure; a tangent, and a normal unless both sensors' places are known, is compared without its
// sign. Omega is scaled by the target point's weight where it has one. Sums are the same for any number of threads.
NormalEquations linearize(const PosedPairs& posed, const Objective& objective, int num_threads);

// b of groups of pairs, each as linearize() has it but for the last digits: those of pairs[begin[g]], ...,
// pairs[begin[g + 1] - 1]. begin ascends from the first group's to the end of the last, and has at least one entry.
std::vector<Vec6d> gradients_of_groups(const PosedPairs& posed, std::span<const std::size_t> begin,
                                       const Objective& objective, int num_threads);

// The two parts of chi2 = e^T Omega e of every pair, before the robust weight. The direction's is negative where it is
// not compared.
struct PairChi2 {
  std::vector<float> position, direction;
};
PairChi2 chi2_of_pairs(const PosedPairs& posed, const InformationModel& information, int num_threads);

}  // namespace augicp
