// SPDX-License-Identifier: MIT
#pragma once

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

}  // namespace augicp
