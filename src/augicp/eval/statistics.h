// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <span>

namespace augicp {

// Statistics of a set of errors. All except count and sse have the unit of the values; sse has its square.
struct Statistics {
  std::size_t count = 0;
  double rmse = 0.0;  // root of the mean square
  double mean = 0.0;
  double median = 0.0;  // for an even count, the mean of the middle two
  double std = 0.0;     // of the population: divided by count, as in NumPy and evo
  double min = 0.0;
  double max = 0.0;
  double sse = 0.0;  // sum of squares
};

// Throws std::invalid_argument for no values, and if they are not finite or their squares overflow.
Statistics statistics_of(std::span<const double> values);

}  // namespace augicp
