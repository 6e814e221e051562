// SPDX-License-Identifier: MIT
#pragma once

#include "augicp/testing/rendering.h"

namespace augicp::testing {

// What a camera sees that reads row by row while it moves evenly: first_from_last is its motion from the first row to the
// last, world_from_middle its pose half way.
DepthImage render_rolling(const Scene& scene, const Pinhole& camera, const Rigid3& world_from_middle,
                          const Rigid3& first_from_last);

}  // namespace augicp::testing
