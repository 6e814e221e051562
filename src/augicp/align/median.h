// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <vector>

namespace augicp {

// The upper median; 0 for no values.
inline double median(std::vector<float> values) {
  if (values.empty()) return 0.0;
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return static_cast<double>(*middle);
}

}  // namespace augicp
