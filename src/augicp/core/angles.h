// SPDX-License-Identifier: MIT
// Angles are radians everywhere inside; degrees are for constants that people read, and for people.
#pragma once

#include <numbers>

namespace augicp {

inline constexpr double kRadPerDeg = std::numbers::pi / 180.0;
inline constexpr double kDegPerRad = 180.0 / std::numbers::pi;

}  // namespace augicp
