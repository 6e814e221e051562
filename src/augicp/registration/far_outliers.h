// SPDX-License-Identifier: MIT
#pragma once

#include "augicp/cloud/cloud.h"

namespace augicp {

// Removes the points farther than the reach (metres) from the component-wise median of all points. A single "no
// reading" at zero in a cloud of UTM coordinates, or one reading at 1e9 m, belongs to no scene and would only stretch
// the grid. A cloud whose bounds have a diagonal no longer than the reach stays as it is. Reentrant.
void drop_far_outliers(Cloud& cloud, double reach);

}  // namespace augicp
