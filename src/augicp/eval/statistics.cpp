// SPDX-License-Identifier: MIT
#include "augicp/eval/statistics.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <vector>

namespace augicp {
namespace {

double median_of(std::span<const double> values) {
  std::vector<double> sorted(values.begin(), values.end());
  const auto middle = sorted.begin() + static_cast<std::ptrdiff_t>(sorted.size() / 2);
  std::nth_element(sorted.begin(), middle, sorted.end());
  return sorted.size() % 2 == 1 ? *middle : 0.5 * (*std::max_element(sorted.begin(), middle) + *middle);
}

}  // namespace

Statistics statistics_of(std::span<const double> values) {
  if (values.empty()) throw std::invalid_argument("statistics: expected values, found none");
  const double count = static_cast<double>(values.size());
  Statistics statistics{.count = values.size()};
  for (const double value : values) {
    statistics.sse += value * value;
    statistics.mean += value / count;
  }
  if (!std::isfinite(statistics.sse))
    throw std::invalid_argument("statistics: the values or their squares are not finite");
  double around_mean = 0.0;
  for (const double value : values) around_mean += (value - statistics.mean) * (value - statistics.mean);
  statistics.rmse = std::sqrt(statistics.sse / count);
  statistics.std = std::sqrt(around_mean / count);
  statistics.median = median_of(values);
  statistics.min = *std::min_element(values.begin(), values.end());
  statistics.max = *std::max_element(values.begin(), values.end());
  return statistics;
}

}  // namespace augicp
