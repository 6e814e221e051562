// SPDX-License-Identifier: MIT
#pragma once

#include "augicp/testing/rendering.h"

namespace augicp::testing {

// The depths of row v of the image that render() gives, in the time of one row.
std::vector<float> render_row(const Scene& scene, const Pinhole& camera, int v, const Rigid3& world_from_camera);

// The image of a camera that reads row by row during an even motion: first_from_last is its motion from the first row
// to the last, world_from_middle its pose half way.
DepthImage render_rolling(const Scene& scene, const Pinhole& camera, const Rigid3& world_from_middle,
                          const Rigid3& first_from_last);

}  // namespace augicp::testing
