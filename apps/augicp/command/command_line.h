// SPDX-License-Identifier: MIT
#pragma once

#include <CLI/CLI.hpp>

namespace augicp::app {

// The whole command: its description, its version, its configuration file and its subcommands. The exit code of the one
// that was chosen is in exit_code after parsing.
void set_up_command_line(CLI::App& app, int& exit_code);

}  // namespace augicp::app
