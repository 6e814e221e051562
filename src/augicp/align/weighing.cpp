// SPDX-License-Identifier: MIT
#include "augicp/align/weighing.h"

#include <algorithm>
#include <cmath>

#include "augicp/align/median.h"

namespace augicp {
namespace {

// K must stay above zero for a perfect fit, whose median is zero.
constexpr double kTiny = 1e-30;

// The lever at which both parts of a typical pair's chi2 are alike.
double measured_lever(const PairChi2& chi2, double max_lever) {
  std::vector<float> position, direction;  // of the pairs that compare directions
  for (std::size_t k = 0; k < chi2.position.size(); ++k) {
    if (chi2.direction[k] < 0.0f) continue;
    position.push_back(chi2.position[k]);
    direction.push_back(chi2.direction[k]);
  }
  const double of_position = median(std::move(position)), of_direction = median(std::move(direction));
  if (!(of_direction > 0.0)) return 0.0;  // no information on directions, or nothing left to learn from them
  return std::min(max_lever, std::sqrt(of_position / of_direction));
}

}  // namespace

Weighing weigh_pairs(const PairChi2& chi2, const AlignOptions& options) {
  Weighing weighing;
  weighing.lever = options.lever ? *options.lever : measured_lever(chi2, options.max_lever);
  if (options.kernel_chi2) {
    weighing.kernel_chi2 = *options.kernel_chi2;
    return weighing;
  }
  const auto scale = static_cast<float>(weighing.lever * weighing.lever);
  std::vector<float> total(chi2.position.size());
  for (std::size_t k = 0; k < total.size(); ++k) total[k] = chi2.position[k] + scale * std::max(chi2.direction[k], 0.0f);
  weighing.kernel_chi2 = std::max(options.kernel_per_median * median(std::move(total)), kTiny);
  return weighing;
}

}  // namespace augicp
