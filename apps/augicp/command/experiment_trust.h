// SPDX-License-Identifier: MIT
// augicp experiment trust: how often a status is right, on generated families of pairs.
#pragma once

#include <CLI/CLI.hpp>

namespace augicp::app {

void add_trust_experiment(CLI::App& experiment, int& exit_code);

}  // namespace augicp::app
