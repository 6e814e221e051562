// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "augicp/cloud/cloud.h"

namespace augicp::app {

// What is odd about a LiDAR scan, for people whose scans could not be tracked: it is not in metres, or not in the
// frame of its sensor. Empty if neither.
std::string scan_advice(const Cloud& scan);

}  // namespace augicp::app
