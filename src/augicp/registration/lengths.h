// SPDX-License-Identifier: MIT
#pragma once

#include "augicp/sensor/scan.h"

namespace augicp {

// The lengths that a registration needs, in metres. Derived from the clouds, so that one set of defaults serves a bunny
// of 15 cm, a depth image and a LiDAR scan.
struct Lengths {
  double extent = 0.0;        // diameter of what most of the points fill
  double voxel_size = 0.0;    // clouds without an image are thinned to one point a voxel
  double radius = 0.0;        // of the ball around a point in which its surface is estimated
  double max_distance = 0.0;  // gate for pairs
};

// The component-wise median of the points, which must not be empty.
Vec3f median_point(const Cloud& cloud);

// Of a cloud: twice the 80th percentile of the distances from the component-wise median; a few far points do not move
// it. Of a depth image: 1.2 times the median distance from the camera, for that is what a view of 60 degrees is wide;
// what happens to lie in the background then matters less. 0 for an empty cloud.
double robust_extent(const Scan& scan);

// The voxel with which a ball of this radius is estimated well and in bounded time, metres.
double voxel_size_for(double radius);

// A voxel that would need more cells than a key of downsample() holds becomes the finest that does not, metres.
double feasible_voxel(const Cloud& cloud, double voxel_size);

// From the geometric mean of both extents, so that swapping the clouds changes nothing.
Lengths derive_lengths(const Scan& source, const Scan& target);

}  // namespace augicp
