// SPDX-License-Identifier: MIT
// Directions from a place to a cloud's points, in patches of a few degrees: a sample of whole patches leaves the
// spacing within them as it is.
#pragma once

#include <vector>

#include "augicp/cloud/cloud.h"

namespace augicp {

struct RayPatch {
  std::vector<Vec3f> rays;     // from the place to points, metres, in the cloud's order; none is zero
  std::vector<float> spacing;  // to the nearest other ray of the patch, radians; in a very full one of some of its rays
};

// Patches around a place (relative to the cloud's origin, metres), spread evenly over all that have enough points to
// tell a distribution. Their size follows the density of the points: some dozens in each. None for few points.
std::vector<RayPatch> ray_patches(const Cloud& cloud, const Vec3f& place);

}  // namespace augicp
