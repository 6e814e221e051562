// SPDX-License-Identifier: MIT
#pragma once

#include <CLI/CLI.hpp>

namespace augicp::app {

// Adds the subcommand; if it is chosen, its exit code is in exit_code after parsing.
void add_verdict_experiment(CLI::App& experiment, int& exit_code);

}  // namespace augicp::app
