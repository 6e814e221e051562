// SPDX-License-Identifier: MIT
// augicp experiment town: writes the scans of a drive around a block of a generated town.
#pragma once

#include <CLI/CLI.hpp>

namespace augicp::app {

void add_town_experiment(CLI::App& experiment, int& exit_code);

}  // namespace augicp::app
