// SPDX-License-Identifier: MIT
// The parts of `augicp experiment`, one file each.
#pragma once

#include <CLI/CLI.hpp>
#include <string>

#include "apps/augicp/progress.h"

namespace augicp::app {

struct ExperimentOutput {
  std::string csv = "-";
  std::string page;  // HTML; empty: none
  Progress progress = Progress::Auto;
};
void add_experiment_output(CLI::App& command, ExperimentOutput& output);

// To a file, whole or not at all, or to stdout for "-".
void write_csv(const std::string& destination, const std::string& text);

void add_synthetic_experiment(CLI::App& experiment, int& exit_code);
void add_sequence_experiment(CLI::App& experiment, int& exit_code);
void add_basin_experiment(CLI::App& experiment, int& exit_code);
void add_verdict_experiment(CLI::App& experiment, int& exit_code);

}  // namespace augicp::app
