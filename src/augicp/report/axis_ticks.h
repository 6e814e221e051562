// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

namespace augicp {

// A range of values on an axis; low is below high.
struct AxisRange {
  double low = 0.0, high = 1.0;
};

// The range of the finite values (of those above 0 for a logarithmic axis), widened where it is a single value; 0 to 1
// (1 to 10) where there are none.
AxisRange range_of(const std::vector<double>& values, bool is_log);

// Round values within the range, about as many as wanted, ascending: 1, 2 or 5 times powers of ten; powers of ten alone
// on a logarithmic axis that has two of them.
std::vector<double> axis_ticks(const AxisRange& range, bool is_log, int num_wanted);

}  // namespace augicp
