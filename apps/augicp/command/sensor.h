// SPDX-License-Identifier: MIT
#pragma once

#include "augicp/core/words.h"

namespace augicp::app {

// What the scans of a sequence come from. Auto: by what is in the folder.
enum class Sensor { Auto, Depth, Lidar };

}  // namespace augicp::app

namespace augicp {
template <>
inline constexpr auto kWords<app::Sensor> = std::to_array<Word<app::Sensor>>({{app::Sensor::Auto, "auto"},
                                                                              {app::Sensor::Depth, "depth"},
                                                                              {app::Sensor::Lidar, "lidar"}});
}  // namespace augicp
