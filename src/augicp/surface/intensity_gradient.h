// SPDX-License-Identifier: MIT
#pragma once

#include "augicp/cloud/cloud.h"
#include "augicp/cloud/index_image.h"

namespace augicp {

// Estimates the gradient of the intensity along the surface at every planar point: the least-squares slope in its
// tangent plane over its nearest points, within radius (metres, above 0). The gradient is zero for other structures, if
// too few points are near, if they lie on a line, and if the slope does not stand out of its residuals. Otherwise noise
// would look like texture and constrain poses that nothing constrains. Existing gradients are replaced. REQUIRES: the
// cloud has intensities and directions.
void estimate_intensity_gradients(Cloud& cloud, double radius, int num_threads);

// The same for a depth image, over the points of the surrounding pixels. Takes a tenth of the time.
void estimate_intensity_gradients(Cloud& cloud, const IndexImage& seen, double radius, int num_threads);

}  // namespace augicp
