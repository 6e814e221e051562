// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "augicp/cloud/cloud.h"

namespace augicp {

// A line to rotate about: a place on it, and its unit direction.
struct RotationAxis {
  Vec3d place, direction;
};

// The line through the mean of a cloud about which its points spread alike to all sides: the principal axis whose
// moment differs most from the other two. An object that repeats itself three times or more about an axis has it there.
// REQUIRES: at least one point, finite.
RotationAxis principal_axis(const Cloud& cloud);

struct RepeatedRotation {
  double angle = 0.0;        // radians, in (0, pi]
  double resemblance = 0.0;  // correlation of the numbers of points, above 0 and at most 1
};

// The rotations about an axis after which a cloud resembles itself: by the teeth of a gear, the spokes of a wheel, five
// bosses on a flange. The best resemblance first; a rotation back by the same angle resembles it as well. None if any
// rotation does: then it is free. Angles are multiples of 3 degrees; repetitions within 9 degrees are not seen. The
// axis may be off by some degrees. REQUIRES: finite points.
std::vector<RepeatedRotation> repeated_rotations(const Cloud& cloud, const RotationAxis& axis);

}  // namespace augicp
