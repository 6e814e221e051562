// SPDX-License-Identifier: MIT
#pragma once

#include "augicp/cloud/cloud.h"
#include "augicp/cloud/index_image.h"

namespace augicp {

// How the intensity changes along the surface around every planar point: the least-squares slope in its tangent plane
// over its nearest points, none farther than radius (metres, above 0). Zero for other structures, where too few points
// are near or lie on a line, and where the slope does not stand out of what it leaves unexplained: noise would
// otherwise look like texture, and hold poses that nothing holds. The cloud needs intensities and directions; gradients
// that it had are replaced.
void estimate_intensity_gradients(Cloud& cloud, double radius, int num_threads);

// The same for what an image shows, over the points of the pixels around each: a tenth of the time.
void estimate_intensity_gradients(Cloud& cloud, const IndexImage& seen, double radius, int num_threads);

}  // namespace augicp
