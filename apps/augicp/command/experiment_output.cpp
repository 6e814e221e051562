// SPDX-License-Identifier: MIT
#include "apps/augicp/command/experiment_output.h"

namespace augicp::app {

void add_experiment_output(CLI::App& command, ExperimentOutput& output) {
  const std::string group = "Output";
  command.add_option("--output", output.csv, "Write the CSV to a file, or to stdout with -")
      ->capture_default_str()
      ->group(group);
  command.add_option("--report", output.page, "Write a report: one HTML file with the curves, readable offline")
      ->group(group);
  add_progress_option(command, output.progress);
}

}  // namespace augicp::app
