// SPDX-License-Identifier: MIT
#pragma once

#include "augicp/sensor/scan.h"
#include "augicp/testing/rendering.h"

namespace augicp::testing {

// The view of a Kinect-like camera on a scene from a place, noise included.
Scan noisy_view(const Scene& scene, const Rigid3& world_from_camera, unsigned seed, int width = 160);

struct ScanPair {
  Scan source, target;
  Rigid3 target_from_source;
};

// A generated room seen from its own place, and from the place after a motion.
ScanPair room_pair(const Rigid3& target_from_source);

}  // namespace augicp::testing
