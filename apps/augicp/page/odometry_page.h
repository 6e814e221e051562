// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "apps/augicp/page/odometry_picture.h"

namespace augicp::app {

// The HTML of `augicp odometry --report`.
std::string odometry_page(const OdometryPicture& picture);

}  // namespace augicp::app
