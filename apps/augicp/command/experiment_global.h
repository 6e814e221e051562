// SPDX-License-Identifier: MIT
#pragma once

#include <CLI/CLI.hpp>

namespace augicp::app {

void add_global_experiment(CLI::App& experiment, int& exit_code);

}  // namespace augicp::app
