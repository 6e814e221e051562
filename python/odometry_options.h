// SPDX-License-Identifier: MIT
#pragma once

#include "augicp/odometry/odometry.h"
#include "python/options.h"

namespace augicp::python {

// Every option of odometry by its keyword, those of its registrations too.
const OptionTable<OdometryOptions>& odometry_options();

}  // namespace augicp::python
