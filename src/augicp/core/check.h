// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <stdexcept>
#include <string>
#include <string_view>

namespace augicp {

// Throws std::invalid_argument "name = value: requirement" unless `holds` is true. For options and arguments, not for
// invariants.
inline void require(bool holds, std::string_view name, double value, std::string_view requirement) {
  if (holds) return;
  throw std::invalid_argument(std::string(name) + " = " + std::to_string(value) + ": " + std::string(requirement));
}

inline void require_positive(std::string_view name, double value) {
  require(std::isfinite(value) && value > 0.0, name, value, "must be finite and above 0");
}

inline void require_not_negative(std::string_view name, double value) {
  require(std::isfinite(value) && value >= 0.0, name, value, "must be finite and at least 0");
}

}  // namespace augicp
