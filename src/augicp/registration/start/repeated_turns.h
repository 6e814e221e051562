// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "augicp/cloud/cloud.h"

namespace augicp {

// A line that a cloud may be turned about: a place on it, and its unit direction.
struct TurningAxis {
  Vec3d place, direction;
};

// The angles in (0, pi], radians, by which a turn about an axis takes a cloud to where it resembles itself: the teeth
// of a gear, the spokes of a wheel, five bosses on a flange. The best resemblance first; a turn back by the
// same angle resembles it as well. None of a cloud that is the same after any turn: there the angle is
// free. Resolved to 3 degrees; periods below 9 are not seen.
struct RepeatedTurn {
  double angle = 0.0;
  double resemblance = 0.0;  // correlation of the number of points, above 0 and at most 1
};
std::vector<RepeatedTurn> repeated_turns(const Cloud& cloud, const TurningAxis& axis);

}  // namespace augicp
