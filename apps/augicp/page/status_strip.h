// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "apps/augicp/text/odometry.h"

namespace augicp::app {

// The name in the style sheet: all frames without usable readings have the same one.
std::string status_class(FrameStatus status);

// A bar with the status of every frame, its key with counts above it, as HTML.
std::string strip_html(const OdometryRun& run);

}  // namespace augicp::app
