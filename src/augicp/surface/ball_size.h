// SPDX-License-Identifier: MIT
#pragma once

#include "augicp/cloud/cloud.h"
#include "augicp/search/cell_grid.h"

namespace augicp {

// How many points a ball around a point of the cloud contains, the point itself included, averaged over the points.
// Estimated from a few hundred of them, in a time that does not grow with the size of the balls: what a
// BallNeighbourhood will need is known before it is made. 0 for an empty cloud. REQUIRES: the grid is of this cloud,
// and its distance is the radius (metres). The same input gives the same value.
double mean_ball_size(const Cloud& cloud, const CellGrid& grid, double radius);

}  // namespace augicp
