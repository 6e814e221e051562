// SPDX-License-Identifier: MIT
#pragma once

#include <span>

namespace augicp {

// The upper median of those values that are not below 0 (nor -0): errors, whose sign may say that there is none. 0
// where all are.
double median(std::span<const float> values);

}  // namespace augicp
