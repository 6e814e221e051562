// SPDX-License-Identifier: MIT
#pragma once

#include <random>

#include "augicp/cloud/cloud.h"

namespace augicp::synthetic {

// A closed, furnished room (testing::room) as a cloud without a sensor's place: four depth images from its upper
// corners, joined and thinned, about 20 000 points. World frame, metres. The noise is that of a Kinect; what no corner
// sees is missing, such as the floor below the table.
Cloud whole_room(unsigned seed, std::mt19937& generator);

}  // namespace augicp::synthetic
