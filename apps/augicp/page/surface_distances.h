// SPDX-License-Identifier: MIT
// How far each source point is from the target's surface under the final pose.
#pragma once

#include <vector>

#include "apps/augicp/page/align_picture.h"

namespace augicp::app {

// One entry per point of the prepared source. Distances are positive on the side of the target's normal, which is the
// sensor's side if its position is known. From an edge or a point without a direction they are not negative.
struct SurfaceDistances {
  std::vector<float> metres;      // NaN: without a correspondence
  std::vector<Vec3f> directions;  // in which they are measured, in the target's frame, unit length; zero: none
};
SurfaceDistances surface_distances(const AlignPicture& picture);

}  // namespace augicp::app
