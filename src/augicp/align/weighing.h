// SPDX-License-Identifier: MIT
#pragma once

#include "augicp/align/align.h"

namespace augicp {

// What one iteration takes from its own pairs before it weighs them.
struct Weighing {
  double lever = 0.0;        // metres, see with_lever()
  double kernel_chi2 = 0.0;  // K of Eq. (13)
  double kernel_direction_chi2 = 0.0;  // see Objective
};

// From the parts of chi2 under a lever of 1 m. Medians, so that up to half of the pairs may be wrong.
Weighing weigh_pairs(const PairChi2& chi2, const AlignOptions& options);

}  // namespace augicp
