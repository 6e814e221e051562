// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "augicp/experiment/random.h"

namespace augicp::testing {

using augicp::gaussian;
using augicp::random_direction;
using augicp::random_motion;
using augicp::uniform;

// Identity, tiny, near pi, far away and random: the poses on which laws break first.
std::vector<Rigid3> awkward_poses();

}  // namespace augicp::testing
