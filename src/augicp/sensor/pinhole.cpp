// SPDX-License-Identifier: MIT
#include "augicp/sensor/pinhole.h"

#include <cmath>
#include <utility>

#include "augicp/core/check.h"

namespace augicp {

void Pinhole::check() const {
  // Far beyond any camera, and within the range of the projection's floats.
  constexpr double kMin = 1e-3, kMax = 1e6;
  for (const auto& [name, value] : {std::pair{"fx", fx}, std::pair{"fy", fy}})
    require(value >= kMin && value <= kMax, name, value, "must be from 0.001 to 1e6 pixels");
  for (const auto& [name, value] : {std::pair{"cx", cx}, std::pair{"cy", cy}})
    require(std::abs(value) <= kMax, name, value, "must be from -1e6 to 1e6 pixels");
}

}  // namespace augicp
