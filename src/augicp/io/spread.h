// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <functional>

#include "augicp/core/types.h"

namespace augicp {

// Where the points are, in metres. Medians are robust against the few points at zero or infinity that mean "no reading"
// in many files.
struct Spread {
  Vec3d centre = Vec3d::Zero();
  double radius = 0.0;  // median distance from the centre, along the farthest axis
};

// The spread of count > 0 points, by at most 4096 of them, evenly chosen.
Spread spread_of(std::size_t count, const std::function<Vec3d(std::size_t)>& point);

// Whether coordinates in float keep the cloud's details: up to 8 radii from zero. Float has 24 bits, so its spacing
// there is below a millionth of the radius.
bool float_suffices(const Spread& spread);

}  // namespace augicp
