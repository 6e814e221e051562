// SPDX-License-Identifier: MIT
#include "augicp/align/weighing.h"

#include <algorithm>
#include <cmath>

#include "augicp/align/median.h"

namespace augicp {
namespace {

// A kernel must stay above zero for a perfect fit, whose medians are zero.
constexpr double kTiny = 1e-30;

// The positions' part of those pairs that compare directions; -1 for the others.
std::vector<float> position_where_compared(const PairChi2& chi2) {
  std::vector<float> position(chi2.position.size());
  for (std::size_t k = 0; k < position.size(); ++k) position[k] = chi2.direction[k] < 0.0f ? -1.0f : chi2.position[k];
  return position;
}

std::vector<float> total_chi2(const PairChi2& chi2, double lever) {
  const auto scale = static_cast<float>(lever * lever);
  std::vector<float> total(chi2.position.size());
  for (std::size_t k = 0; k < total.size(); ++k) total[k] = chi2.position[k] + scale * std::max(chi2.direction[k], 0.0f);
  return total;
}

}  // namespace

Weighing weigh_pairs(const PairChi2& chi2, const AlignOptions& options) {
  const double of_position = median(position_where_compared(chi2)), of_direction = median(chi2.direction);
  Weighing weighing;
  // Where directions carry no information, or nothing is left to learn from them, the lever is 0.
  const double measured = of_direction > 0.0 ? std::sqrt(of_position / of_direction) : 0.0;
  weighing.lever = options.lever.value_or(std::min(options.max_lever, measured));
  weighing.kernel_chi2 = options.kernel_chi2
                             ? *options.kernel_chi2
                             : std::max({kTiny, options.min_kernel_chi2,
                                         options.kernel_per_median * median(total_chi2(chi2, weighing.lever))});
  weighing.kernel_direction_chi2 =
      std::max(kTiny, options.kernel_direction_per_median * weighing.lever * weighing.lever * of_direction);
  return weighing;
}

}  // namespace augicp
