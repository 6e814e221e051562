// SPDX-License-Identifier: MIT
#pragma once

#include <span>

#include "augicp/cloud/correspondence.h"
#include "augicp/sensor/scan.h"

namespace augicp {

// How two rolling-shutter cameras moved while each read out its image, as without_skew() takes it: the pose at the last
// row in the frame of the first.
struct ReadoutMotion {
  Rigid3 source, target;
};

// Two scans as they were read, with views and points in raster order, and the same without the skew of the motion known
// so far.
struct SkewedPair {
  const Scan& source;
  const Scan& target;
  Scan straight_source, straight_target;
};

// The motion that the pairs show, found so far and improved by one step. Each camera's motion adds six unknowns to the
// pose's: a point read at time tau of the readout, from -1/2 at the first row to 1/2 at the last, is off by tau times
// the motion, so that the derivatives of Eq. (12) for it are tau times those for the pose; all eighteen are solved for
// at once. A scene shows little more than the difference of both motions. What it does not show is held near zero by
// how fast hands turn and move a camera.
ReadoutMotion improved(const ReadoutMotion& so_far, const SkewedPair& scans, std::span<const Correspondence> pairs,
                       const Rigid3& target_from_source);

}  // namespace augicp
