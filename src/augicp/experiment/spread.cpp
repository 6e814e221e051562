// SPDX-License-Identifier: MIT
#include "augicp/experiment/spread.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "augicp/core/check.h"
#include "augicp/eval/statistics.h"

namespace augicp {
namespace {

// The share of Student's distribution between -t and t, for whole degrees of freedom (Abramowitz and Stegun 26.7.3,
// 26.7.4).
double student_share_within(double t, std::size_t degrees_of_freedom) {
  const double angle = std::atan(t / std::sqrt(static_cast<double>(degrees_of_freedom)));
  const double cosine = std::cos(angle), sine = std::sin(angle);
  const bool is_odd = degrees_of_freedom % 2 == 1;
  double term = is_odd ? cosine : 1.0, sum = 0.0;
  for (std::size_t k = is_odd ? 3 : 2; k <= degrees_of_freedom; k += 2) {
    sum += term;
    term *= cosine * cosine * static_cast<double>(k - 1) / static_cast<double>(k);
  }
  return is_odd ? 2.0 / std::numbers::pi * (angle + sine * sum) : sine * sum;
}

}  // namespace

double quantile(std::vector<double> values, double share) {
  require(share >= 0.0 && share <= 1.0, "share", share, "must be in [0, 1]");
  require(!values.empty(), "values", 0.0, "expected some, found none");
  std::sort(values.begin(), values.end());
  const double place = share * static_cast<double>(values.size() - 1);
  const auto below = static_cast<std::size_t>(place);
  const std::size_t above = std::min(below + 1, values.size() - 1);
  return values[below] + (place - static_cast<double>(below)) * (values[above] - values[below]);
}

Spread spread_of(std::span<const double> values) {
  const Statistics statistics = statistics_of(values);
  const std::vector<double> copy(values.begin(), values.end());
  return {statistics.mean, statistics.median, quantile(copy, 0.1), quantile(copy, 0.9)};
}

MeanInterval mean_interval(std::span<const double> values) {
  const Statistics statistics = statistics_of(values);
  if (values.size() < 2) return {statistics.mean, std::numeric_limits<double>::infinity()};
  // statistics.std divides by the count; the standard error of a mean divides by one less.
  const double degrees_of_freedom = static_cast<double>(values.size() - 1);
  return {statistics.mean, student_quantile(0.975, values.size() - 1) * statistics.std / std::sqrt(degrees_of_freedom)};
}

double student_quantile(double share, std::size_t degrees_of_freedom) {
  require(share > 0.5 && share < 1.0, "share", share, "must be in (0.5, 1)");
  require(degrees_of_freedom >= 1, "degrees_of_freedom", 0.0, "must be at least 1");
  const auto is_enough = [&](double t) { return student_share_within(t, degrees_of_freedom) >= 2.0 * share - 1.0; };
  double low = 0.0, high = 1.0;
  while (!is_enough(high)) high *= 2.0;
  for (int halving = 0; halving < 60; ++halving) {
    const double middle = 0.5 * (low + high);
    (is_enough(middle) ? high : low) = middle;
  }
  return high;
}

}  // namespace augicp
