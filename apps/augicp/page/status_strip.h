// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "apps/augicp/text/odometry.h"

namespace augicp::app {

// A bar with the status of every frame, its key with counts above it, as HTML.
std::string strip_html(const OdometryRun& run);

}  // namespace augicp::app
