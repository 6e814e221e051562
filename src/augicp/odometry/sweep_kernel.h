// SPDX-License-Identifier: MIT
// How pairs of a sweep count.
#pragma once

#include <cmath>
#include <utility>
#include <vector>

#include "augicp/core/median.h"

namespace augicp {

// Pairs count fully up to about this many median residuals: parts of a sweep that the motion bends, and moving things,
// are a large minority of coherent pairs.
inline constexpr double kKernelPerMedian = 3.0;

// The median size of the errors of rows, at least one.
template <typename Row>
double median_size(const std::vector<Row>& rows) {
  std::vector<double> sizes;
  sizes.reserve(rows.size());
  for (const Row& row : rows) sizes.push_back(std::abs(row.error));
  return upper_median(std::move(sizes));
}

// The weight of an error, of the Geman-McClure kernel of this width.
inline double kernel_weight(double error, double width) { return 1.0 / std::pow(1.0 + std::pow(error / width, 2), 2); }

}  // namespace augicp
