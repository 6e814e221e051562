// SPDX-License-Identifier: MIT
// Statistics of a repeated measurement.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace augicp {

// Centre and scatter of values, in their unit.
struct Spread {
  double mean = 0.0, median = 0.0;
  double p10 = 0.0, p90 = 0.0;  // 10th and 90th percentile
};

// The value below which a share in [0, 1] of the values lies, linear between neighbours (NumPy's default). Throws
// std::invalid_argument for no values and for a share outside [0, 1].
double quantile(std::vector<double> values, double share);

// Throws std::invalid_argument as statistics_of does.
Spread spread_of(std::span<const double> values);

// A mean with its 95 % interval, mean - half_width to mean + half_width, by Student's t for normal errors.
struct MeanInterval {
  double mean = 0.0;
  double half_width = 0.0;  // infinity for a single value
};
MeanInterval mean_interval(std::span<const double> values);

// The quantile of Student's distribution at a share in (0.5, 1); degrees of freedom at least 1.
double student_quantile(double share, std::size_t degrees_of_freedom);

}  // namespace augicp
