// SPDX-License-Identifier: MIT
#pragma once

#include "apps/augicp/odometry_view.h"

namespace augicp::app {

// The depth images, read once more, and the local models of the frames that are kept.
nlohmann::ordered_json kept_json(const OdometryPicture& picture, const OdometryView& view);

}  // namespace augicp::app
