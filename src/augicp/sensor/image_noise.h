// SPDX-License-Identifier: MIT
#pragma once

#include "augicp/sensor/scan.h"

namespace augicp {

// How noisy a depth image is, measured from itself: s where the standard deviation of a reading at depth z is s z^2, in
// 1 / m (DepthNoise). Three readings side by side on a surface lie on a line but for their noise; half of the triples
// have a larger deviation. Readings in steps wider than their noise show none. 0 for an image with fewer than three
// readings side by side. The scan must have a view.
double noise_per_depth_sq(const Scan& image);

}  // namespace augicp
