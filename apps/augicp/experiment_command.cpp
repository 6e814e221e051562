// SPDX-License-Identifier: MIT
#include <fmt/core.h>

#include "apps/augicp/commands.h"
#include "apps/augicp/experiment_commands.h"
#include "apps/augicp/interruption.h"
#include "apps/augicp/names.h"
#include "augicp/io/atomic_file.h"

namespace augicp::app {

void add_experiment_output(CLI::App& command, ExperimentOutput& output) {
  const std::string group = "Output";
  command.add_option("--output", output.csv, "Write the CSV to a file, or to stdout with -")
      ->capture_default_str()
      ->group(group);
  command
      .add_option("--report", output.page, "Write a page to look at: one HTML file with the curves, needs no network")
      ->group(group);
  command.add_option("--progress", output.progress, "A bar on the terminal: auto or none (default auto)")
      ->transform(CLI::CheckedTransformer(kProgress).description("{auto,none}"))
      ->group(group);
}

void write_csv(const std::string& destination, const std::string& text) {
  if (destination == "-")
    fmt::print("{}", text);
  else
    write_whole([&] { write_file(destination, text); });
}

void add_experiment_command(CLI::App& app, int& exit_code) {
  CLI::App* command =
      app.add_subcommand("experiment", "Measure how registration converges: the paper's tables, and more");
  command->require_subcommand(1);
  add_synthetic_experiment(*command, exit_code);
  add_sequence_experiment(*command, exit_code);
  add_basin_experiment(*command, exit_code);
  add_verdict_experiment(*command, exit_code);
  command->footer(
      "Each writes CSV, the same bytes for the same seed and any number of threads. experiments/ draws the pictures.\n"
      "Examples:\n"
      "  augicp experiment synthetic --points 20000 --seeds 3 --output table4.csv\n"
      "  augicp experiment sequence rgbd_dataset_freiburg1_room --camera tum-fr1 --pairs 100 --output table3.csv\n"
      "  augicp experiment basin scan_b.ply scan_a.ply --truth T.txt --distances 0,0.1,0.2 --report basin.html");
}

}  // namespace augicp::app
