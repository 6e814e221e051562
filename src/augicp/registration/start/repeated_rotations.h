// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "augicp/registration/start/principal_axis.h"

namespace augicp {

struct RepeatedRotation {
  double angle = 0.0;        // radians, in (0, pi]
  double resemblance = 0.0;  // correlation of the numbers of points, above 0 and at most 1
};

// The rotations about an axis after which a cloud resembles itself: by the teeth of a gear, the spokes of a wheel, five
// bosses on a flange. The best resemblance first; a rotation back by the same angle resembles it as well. None if any
// rotation does: then it is free. Angles are multiples of 3 degrees; repetitions within 9 degrees are not seen. The
// axis may be off by a degree. REQUIRES: finite points.
std::vector<RepeatedRotation> repeated_rotations(const Cloud& cloud, const RotationAxis& axis);

}  // namespace augicp
