// SPDX-License-Identifier: MIT
// The true edges of a rendered scene, and its jumps in depth.
#pragma once

#include <limits>
#include <vector>

#include "augicp/testing/rendering.h"

namespace augicp::testing {

// The parts of the scene's creases that the camera can see: both surfaces are seen within radius (metres) of every
// point of a part. A contour in front of a hidden face is no crease. In the camera frame.
std::vector<Crease> visible_creases(const Scene& scene, const Rendering& seen, double radius);

struct NearestCrease {
  double distance = std::numeric_limits<double>::infinity();  // metres; infinite if there is no crease
  Vec3d tangent = Vec3d::Zero();
};
NearestCrease nearest_crease(const std::vector<Crease>& creases, const Vec3d& point);

// Pixels (true) with another surface, or nothing at all, within radius_px of them across a jump of more than jump
// metres in depth. Row-major.
std::vector<bool> beside_discontinuity(const Rendering& seen, int radius_px, double jump);

}  // namespace augicp::testing
