// SPDX-License-Identifier: MIT
// The output options of all experiments.
#pragma once

#include <CLI/CLI.hpp>
#include <string>

#include "apps/augicp/command/progress.h"

namespace augicp::app {

struct ExperimentOutput {
  std::string csv = "-";
  std::string page;  // HTML; empty: none
  Progress progress = Progress::Auto;
};
void add_experiment_output(CLI::App& command, ExperimentOutput& output);

}  // namespace augicp::app
