// SPDX-License-Identifier: MIT
// Trajectories as lines in a page.
#pragma once

#include <string>

#include "augicp/geometry/trajectory.h"

namespace augicp::app {

// The poses from a tenth of a second before the first stamp to a tenth behind the last one, downsampled to at most
// 5000.
Trajectory during(const Trajectory& trajectory, double first_s, double last_s);

// Consecutive positions less the centre, two points a line, as packed points. Poses more than a second, and more
// than four usual gaps, apart are not joined.
std::string trajectory_lines(const Trajectory& trajectory, const Vec3d& centre);

}  // namespace augicp::app
