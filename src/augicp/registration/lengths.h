// SPDX-License-Identifier: MIT
#pragma once

#include "augicp/registration/scan.h"

namespace augicp {

// The lengths that a registration needs, in metres. Derived from the clouds, so that one set of defaults serves a bunny
// of 15 cm, a depth image and a LiDAR scan.
struct Lengths {
  double extent = 0.0;        // diameter of what most of the points fill
  double voxel_size = 0.0;    // clouds without an image are thinned to one point a voxel
  double radius = 0.0;        // of the ball around a point in which its surface is estimated
  double max_distance = 0.0;  // gate for pairs
};

// Twice the 80th percentile of the distances from the component-wise median: a few far points do not move it, and it
// turns with the cloud to within the median's own dependence on the axes. 0 for an empty cloud.
double robust_extent(const Cloud& cloud);

// From the geometric mean of both extents, so that swapping the clouds changes nothing.
Lengths derive_lengths(const Scan& source, const Scan& target);

}  // namespace augicp
