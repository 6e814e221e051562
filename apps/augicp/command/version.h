// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace augicp::app {

// "augicp VERSION", and below it what a bug report needs: commit, compiler, instructions, optional parts.
std::string version_text();

}  // namespace augicp::app
