// SPDX-License-Identifier: MIT
#pragma once

#include "augicp/cloud/index_image.h"
#include "augicp/surface/estimate_surface.h"
#include "augicp/surface/window_neighbourhood.h"

namespace augicp {

// estimate_surface() with a WindowNeighbourhood, many times faster: the same windows, steps and thresholds, in another
// order of memory and with eigenvectors in closed form. Rounding may decide differently at a threshold. Bit-identical
// for any number of threads. REQUIRES: the index image is the cloud's own, each point in its pixel.
void estimate_surface(Cloud& cloud, const IndexImage& index, const WindowOptions& window, const SurfaceOptions& options,
                      int num_threads);

}  // namespace augicp
