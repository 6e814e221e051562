// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <span>
#include <utility>
#include <vector>

namespace augicp {

// The standard deviation of normally distributed numbers, divided by the median of their sizes.
inline constexpr double kSigmaPerMedian = 1.4826;

// The upper median of the values that are at least +0. Negative values and -0 mark missing errors and are skipped. 0 if
// no value is left.
double median(std::span<const float> values);

// The value that would be at this place, below the number of values, were they in ascending order. None may be NaN.
template <typename Number>
Number value_at_rank(std::vector<Number> values, std::size_t rank) {
  const auto place = values.begin() + static_cast<std::ptrdiff_t>(rank);
  std::nth_element(values.begin(), place, values.end());
  return *place;
}

// The upper median of at least one value of any sign. None may be NaN.
template <typename Number>
Number upper_median(std::vector<Number> values) {
  const std::size_t middle = values.size() / 2;
  return value_at_rank(std::move(values), middle);
}

}  // namespace augicp
