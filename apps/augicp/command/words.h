// SPDX-License-Identifier: MIT
// The words of the command line for choices.
#pragma once

#include "apps/augicp/command/progress.h"
#include "augicp/eval/words.h"
#include "augicp/odometry/words.h"
#include "augicp/registration/words.h"

namespace augicp::app {

inline const std::map<std::string, Progress> kProgress{{"auto", Progress::Auto}, {"none", Progress::None}};

}  // namespace augicp::app
