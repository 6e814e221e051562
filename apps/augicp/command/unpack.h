// SPDX-License-Identifier: MIT
#pragma once

#include <CLI/CLI.hpp>

namespace augicp::app {

void add_unpack_command(CLI::App& app, int& exit_code);

}  // namespace augicp::app
