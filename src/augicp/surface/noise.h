// SPDX-License-Identifier: MIT
// How noisy a scan is, measured from the scan itself.
#pragma once

#include "augicp/cloud/cloud.h"

namespace augicp {

// Standard deviations. Meant for every limit and weight that would otherwise assume a sensor: nearness, gates, kernels,
// weights of one scan beside the other's.
struct ScanNoise {
  // Of a point along its line of sight at `range` metres from the sensor: sqrt(constant^2 + (per_m2 * range^2)^2), in
  // metres. Time-of-flight sensors have the first part, triangulating ones the second. Where the cloud has no
  // viewpoint, per_m2 is zero and the constant is the deviation across the surface.
  double constant = 0.0;  // metres
  double per_m2 = 0.0;    // 1 / m
  double range_sigma(double range) const;

  // Of a normal that is estimated from the points in a ball of the given radius, about each axis in the surface,
  // radians: the median over the points that lie on a plane.
  double direction = 0.0;

  // How many points had a plane around them to be compared with. 0: nothing was measured, all else is zero.
  std::size_t num_measured = 0;
};

// From the residuals of at most 2048 points' neighbours to their local planes. Measures what the points have left:
// of a raw scan the sensor's noise, of a downsampled one what remains after averaging. `radius`: of the balls in which
// normals are estimated, metres, above zero. The same bits on any number of threads.
// Throws std::invalid_argument where the radius is not positive.
ScanNoise measured_noise(const Cloud& cloud, double radius, int num_threads);

}  // namespace augicp
