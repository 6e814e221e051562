// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

namespace augicp::app {

// A range of values on an axis; low is below high.
struct AxisRange {
  double low = 0.0, high = 1.0;
};

// The range of the finite values (of the positive ones for a logarithmic axis), widened if it is a single value.
// Without values: 0 to 1 (logarithmic: 1 to 10).
AxisRange range_of(const std::vector<double>& values, bool is_log);

// Round values within the range, about num_wanted of them, ascending: 1, 2 or 5 times powers of ten. On a logarithmic
// axis with at least two powers of ten: these alone.
std::vector<double> axis_ticks(const AxisRange& range, bool is_log, int num_wanted);

}  // namespace augicp::app
