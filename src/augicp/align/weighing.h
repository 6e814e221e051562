// SPDX-License-Identifier: MIT
#pragma once

#include <limits>

#include "augicp/align/align.h"

namespace augicp {

// Weights that an iteration derives from its own pairs.
struct Weighing {
  double lever = 0.0;                                                      // metres, see with_lever()
  double kernel_chi2 = 0.0;                                                // K of Eq. (13)
  double kernel_direction_chi2 = std::numeric_limits<double>::infinity();  // see Objective
};

// From the parts of chi2 with a lever of 1 m. Uses medians, so up to half of the pairs may be wrong.
Weighing weigh_pairs(const PairChi2& chi2, const AlignOptions& options);

// The weight of intensities against positions: the median of their chi2 becomes intensity_weight times that of the
// positions, with a lever of 1 m. Two limits: the positions' median counts as at least min_kernel_chi2, and a typical
// gradient constrains a point at most as firmly as the normal of a plane. Otherwise a perfect match of brightness would
// silence the positions. The offset between the clouds is the median too. Off if no intensity is compared.
IntensityModel weigh_intensities(const PosedPairs& posed, const PairChi2& chi2, const AlignOptions& options);

}  // namespace augicp
