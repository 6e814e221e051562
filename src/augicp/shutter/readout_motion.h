// SPDX-License-Identifier: MIT
#pragma once

#include <span>

#include "augicp/cloud/correspondence.h"
#include "augicp/sensor/scan.h"

namespace augicp {

// The motions of two rolling-shutter cameras during the readout of their images, in the form of without_skew(): the
// pose at the last row in the frame of the first.
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

// Improves the motion by one step, from the pairs. Each camera's motion adds six unknowns to the pose. A point read at
// time tau of the readout, from -1/2 at the first row to 1/2 at the last, is off by tau times the motion. So its
// derivatives of Eq. (12) are tau times those of the pose; all eighteen unknowns are solved at once. A scene constrains
// little more than the difference of both motions. A prior for the speed of hand-held cameras keeps the rest near zero.
ReadoutMotion improved(const ReadoutMotion& so_far, const SkewedPair& scans, std::span<const Correspondence> pairs,
                       const Rigid3& target_from_source);

}  // namespace augicp
