// SPDX-License-Identifier: MIT
#pragma once

#include <limits>

#include "augicp/align/align.h"

namespace augicp {

// What one iteration takes from its own pairs before it weighs them.
struct Weighing {
  double lever = 0.0;                                                      // metres, see with_lever()
  double kernel_chi2 = 0.0;                                                // K of Eq. (13)
  double kernel_direction_chi2 = std::numeric_limits<double>::infinity();  // see Objective
};

// From the parts of chi2 under a lever of 1 m. Medians, so that up to half of the pairs may be wrong.
Weighing weigh_pairs(const PairChi2& chi2, const AlignOptions& options);

// How intensities weigh beside positions: so that the median of their chi2 is intensity_weight times that of the
// positions, which are the pairs' under a lever of 1 m and are not taken to be better than what min_kernel_chi2 says of
// them. But a typical gradient holds a point no more firmly than a plane's normal does, or a perfect match of
// brightness would silence the positions. The offset between the clouds is the median too. Off where no intensity is
// compared.
IntensityModel weigh_intensities(const PosedPairs& posed, const PairChi2& chi2, const AlignOptions& options);

}  // namespace augicp
