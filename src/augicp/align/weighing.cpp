// SPDX-License-Identifier: MIT
#include "augicp/align/weighing.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "augicp/core/median.h"

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
  for (std::size_t k = 0; k < total.size(); ++k)
    total[k] = chi2.position[k] + scale * std::max(chi2.direction[k], 0.0f);
  return total;
}

// At a half it is median(), the upper of the two middle ones.
double typical(std::vector<float> values, double quantile) {
  if (values.empty()) return 0.0;
  const auto rank = static_cast<std::size_t>(quantile * static_cast<double>(values.size()));
  return static_cast<double>(value_at_rank(std::move(values), rank));
}

struct Measured {
  double offset = 0.0;
  std::vector<float> squared_errors, squared_gradients;  // of the pairs that are compared
};

Measured measured_intensities(const PosedPairs& posed, int num_threads) {
  const std::vector<float> residuals = intensity_residuals(posed, num_threads);
  Measured measured;
  for (std::size_t k = 0; k < posed.size(); ++k) {
    if (std::isnan(residuals[k])) continue;
    measured.squared_errors.push_back(residuals[k]);
    measured.squared_gradients.push_back(posed.target.intensity_gradients[posed.pairs[k].target].squaredNorm());
  }
  if (measured.squared_errors.empty()) return measured;
  measured.offset = static_cast<double>(upper_median(measured.squared_errors));
  for (float& error : measured.squared_errors) {
    error -= static_cast<float>(measured.offset);
    error *= error;
  }
  return measured;
}

}  // namespace

Weighing weigh_pairs(const PairChi2& chi2, const AlignOptions& options) {
  const double of_position = median(position_where_compared(chi2)), of_direction = median(chi2.direction);
  Weighing weighing;
  // Where directions carry no information, or nothing is left to learn from them, the lever is 0.
  const double measured = of_direction > 0.0 ? std::sqrt(of_position / of_direction) : 0.0;
  weighing.lever = options.lever.value_or(std::min(options.max_lever, measured));
  weighing.kernel_chi2 =
      options.kernel_chi2
          ? *options.kernel_chi2
          : std::max({kTiny, options.min_kernel_chi2,
                      options.kernel_per_median * typical(total_chi2(chi2, weighing.lever), options.kernel_quantile)});
  if (std::isfinite(options.kernel_direction_per_median))
    weighing.kernel_direction_chi2 =
        std::max(kTiny, options.kernel_direction_per_median * weighing.lever * weighing.lever * of_direction);
  return weighing;
}

IntensityModel weigh_intensities(const PosedPairs& posed, const PairChi2& chi2, const AlignOptions& options) {
  if (!(options.intensity_weight > 0.0) || !compares_intensities(posed.source, posed.target)) return {};
  const Measured measured = measured_intensities(posed, options.num_threads);
  if (measured.squared_errors.empty()) return {};
  const double of_intensity = median(measured.squared_errors), gradient_sq = median(measured.squared_gradients);
  const double of_position = std::max(median(chi2.position), options.min_kernel_chi2 / options.kernel_per_median);
  const Information& plane = options.information.planar.position;
  const double most = std::max(plane.along, plane.across) / gradient_sq;
  IntensityModel model;
  model.offset = measured.offset;
  model.information = of_intensity > 0.0 ? std::min(most, options.intensity_weight * of_position / of_intensity) : most;
  model.kernel_chi2 = std::max(kTiny, options.kernel_intensity_per_median * model.information * of_intensity);
  return model;
}

}  // namespace augicp
