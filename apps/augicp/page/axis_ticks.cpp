// SPDX-License-Identifier: MIT
#include "apps/augicp/page/axis_ticks.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace augicp::app {
namespace {

// Larger values are not drawn to scale: their differences would overflow.
constexpr double kLargest = 1e300;

double round_step(double least) {
  const double power = std::pow(10.0, std::floor(std::log10(least)));
  for (const double factor : {1.0, 2.0, 5.0})
    if (factor * power >= least * (1.0 - 1e-9)) return factor * power;
  return 10.0 * power;
}

std::vector<double> powers_of_ten(const AxisRange& range, int num_wanted) {
  const int first = static_cast<int>(std::ceil(std::log10(range.low) - 1e-9));
  const int last = static_cast<int>(std::floor(std::log10(range.high) + 1e-9));
  const int step = std::max(1, (last - first + num_wanted) / num_wanted);
  std::vector<double> ticks;
  for (int power = first; power <= last; power += step) ticks.push_back(std::pow(10.0, power));
  return ticks;
}

}  // namespace

AxisRange range_of(const std::vector<double>& values, bool is_log) {
  AxisRange range{std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
  for (const double value : values)
    if (std::abs(value) <= kLargest && (!is_log || value >= 1.0 / kLargest)) {
      range.low = std::min(range.low, value);
      range.high = std::max(range.high, value);
    }
  if (range.low > range.high) return is_log ? AxisRange{1.0, 10.0} : AxisRange{0.0, 1.0};
  if (range.high - range.low > 1e-9 * std::abs(range.high)) return range;
  if (is_log) return {range.low / 2.0, range.high * 2.0};
  const double margin = range.high == 0.0 ? 0.5 : 0.1 * std::abs(range.high);
  return {range.low - margin, range.high + margin};
}

std::vector<double> axis_ticks(const AxisRange& range, bool is_log, int num_wanted) {
  if (is_log) {
    const std::vector<double> ticks = powers_of_ten(range, num_wanted);
    if (ticks.size() >= 2) return ticks;
  }
  const double step = round_step((range.high - range.low) / num_wanted);
  std::vector<double> ticks;
  const double first = std::ceil(range.low / step - 1e-9);
  const int count = static_cast<int>(std::floor(range.high / step + 1e-9) - first) + 1;
  for (int i = 0; i < count; ++i) ticks.push_back((first + i) * step);
  return ticks;
}

}  // namespace augicp::app
