// SPDX-License-Identifier: MIT
#pragma once

#include "augicp/sensor/scan.h"
#include "augicp/testing/rendering.h"

namespace augicp::testing {

// What a Kinect-like camera, noise included, sees of a scene from a place.
Scan noisy_view(const Scene& scene, const Rigid3& world_from_camera, unsigned seed, int width = 160);

struct ScanPair {
  Scan source, target;
  Rigid3 target_from_source;
};

// A generated room seen from its own place and from one that a motion leads to.
ScanPair room_pair(const Rigid3& target_from_source);

}  // namespace augicp::testing
