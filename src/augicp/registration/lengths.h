// SPDX-License-Identifier: MIT
#pragma once

#include "augicp/sensor/scan.h"

namespace augicp {

// The lengths of a registration, in metres. They are derived from the clouds, so that one set of defaults serves a
// bunny of 15 cm, a depth image and a LiDAR scan.
struct Lengths {
  double extent = 0.0;        // diameter of the region with most of the points
  double voxel_size = 0.0;    // clouds without an image are downsampled to one point per voxel
  double radius = 0.0;        // radius of the ball around a point for surface estimation
  double max_distance = 0.0;  // gate for pairs
};

// The component-wise median of the points. REQUIRES: there is a point.
Vec3f median_point(const Cloud& cloud);

// For a cloud: twice the 80th percentile of the distances from the component-wise median; a few far points do not
// change it. For a depth image: 1.2 times the median distance from the camera, which is the width of a view of 60
// degrees; the background then matters less. 0 for an empty cloud.
double robust_extent(const Scan& scan);

// The voxel size with which a ball of this radius is estimated well and in bounded time, metres.
double voxel_size_for(double radius);

// The voxel size itself or, if it needs more cells than a key of downsample() has, the smallest possible one, metres.
double feasible_voxel(const Cloud& cloud, double voxel_size);

// The same with radius and voxels of this share of theirs.
Lengths finer_lengths(Lengths lengths, double share);

// From the geometric mean of both extents, so that swapping the clouds changes nothing.
Lengths derive_lengths(const Scan& source, const Scan& target, int num_threads = 1);

}  // namespace augicp
