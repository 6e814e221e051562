// SPDX-License-Identifier: MIT
#pragma once

#include "augicp/sensor/scan.h"

namespace augicp {

// This part of a motion that goes on evenly: the rotation by that part of its angle, that part of the translation. Also
// beyond 1 and below 0.
Rigid3 part_of(const Rigid3& motion, double share);

// What the camera would have seen had it read all rows at the moment of the middle one. A rolling shutter reads row by
// row while the camera moves, and so bends what it sees: at 80 degrees a second by more than two degrees from top to
// bottom. first_from_last is the camera's motion during one readout, assumed even: the pose at the last row in the
// frame of the first. The scan must have a view, its points in raster order.
Scan without_skew(const Scan& scan, const Rigid3& first_from_last, int num_threads);

}  // namespace augicp
