// SPDX-License-Identifier: MIT
#include "augicp/align/weighing.h"

#include <algorithm>
#include <cmath>

#include "augicp/align/median.h"

namespace augicp {
namespace {

// A kernel must stay above zero for a perfect fit, whose medians are zero.
constexpr double kTiny = 1e-30;

// The parts of chi2 of the pairs that compare directions.
PairChi2 comparing_directions(const PairChi2& chi2) {
  PairChi2 chosen;
  for (std::size_t k = 0; k < chi2.position.size(); ++k) {
    if (chi2.direction[k] < 0.0f) continue;
    chosen.position.push_back(chi2.position[k]);
    chosen.direction.push_back(chi2.direction[k]);
  }
  return chosen;
}

std::vector<float> total_chi2(const PairChi2& chi2, double lever) {
  const auto scale = static_cast<float>(lever * lever);
  std::vector<float> total(chi2.position.size());
  for (std::size_t k = 0; k < total.size(); ++k) total[k] = chi2.position[k] + scale * std::max(chi2.direction[k], 0.0f);
  return total;
}

}  // namespace

Weighing weigh_pairs(const PairChi2& chi2, const AlignOptions& options) {
  const PairChi2 comparing = comparing_directions(chi2);
  const double of_position = median(comparing.position), of_direction = median(comparing.direction);
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
