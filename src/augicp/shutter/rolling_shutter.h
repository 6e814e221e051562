// SPDX-License-Identifier: MIT
#pragma once

#include "augicp/sensor/scan.h"

namespace augicp {

// A part of an even motion: the rotation by that share of its angle, and that share of the translation. Shares above 1
// and below 0 are allowed.
Rigid3 part_of(const Rigid3& motion, double share);

// The scan as if the camera had read all rows at the moment of the middle one. A rolling shutter reads row by row while
// the camera moves, and so distorts the image: at 80 degrees a second by more than two degrees from top to bottom.
// first_from_last is the camera's motion during one readout, assumed even: the pose at the last row in the frame of the
// first. REQUIRES: the scan has a view, and its points are in raster order.
Scan without_skew(const Scan& scan, const Rigid3& first_from_last, int num_threads);

}  // namespace augicp
