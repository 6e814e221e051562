// SPDX-License-Identifier: MIT
#pragma once

#include <CLI/CLI.hpp>

namespace augicp::app {

// Sets up the whole command: its description, version, configuration file and subcommands. The exit code of the chosen
// one is in exit_code after parsing.
void set_up_command_line(CLI::App& app, int& exit_code);

}  // namespace augicp::app
