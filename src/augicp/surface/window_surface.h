// SPDX-License-Identifier: MIT
#pragma once

#include "augicp/cloud/index_image.h"
#include "augicp/surface/estimate_surface.h"
#include "augicp/surface/window_neighbourhood.h"

namespace augicp {

// What estimate_surface() does with a WindowNeighbourhood, many times faster: the same windows, the same three steps
// and thresholds, in another order of memory and with eigenvectors in closed form. Rounding may decide otherwise on a
// threshold. The index image must be the cloud's own: each point in its pixel. Same bits for any number of threads.
void estimate_surface(Cloud& cloud, const IndexImage& index, const WindowOptions& window, const SurfaceOptions& options,
                      int num_threads);

}  // namespace augicp
