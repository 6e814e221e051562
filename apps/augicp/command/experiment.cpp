// SPDX-License-Identifier: MIT
#include "apps/augicp/command/experiment.h"

#include "apps/augicp/command/experiment_basin.h"
#include "apps/augicp/command/experiment_global.h"
#include "apps/augicp/command/experiment_sequence.h"
#include "apps/augicp/command/experiment_synthetic.h"
#include "apps/augicp/command/experiment_town.h"
#include "apps/augicp/command/experiment_trust.h"
#include "apps/augicp/command/experiment_verdict.h"

namespace augicp::app {

void add_experiment_command(CLI::App& app, int& exit_code) {
  CLI::App* command =
      app.add_subcommand("experiment", "Measure how registration converges: the paper's tables, and more");
  command->require_subcommand(1);
  add_synthetic_experiment(*command, exit_code);
  add_sequence_experiment(*command, exit_code);
  add_basin_experiment(*command, exit_code);
  add_verdict_experiment(*command, exit_code);
  add_trust_experiment(*command, exit_code);
  add_global_experiment(*command, exit_code);
  add_town_experiment(*command, exit_code);
  command->footer(
      "Each writes CSV, the same bytes for the same seed and any number of threads. experiments/ draws the pictures.\n"
      "Examples:\n"
      "  augicp experiment synthetic --points 20000 --seeds 3 --output table4.csv\n"
      "  augicp experiment sequence rgbd_dataset_freiburg1_room --camera tum-fr1 --pairs 100 --output table3.csv\n"
      "  augicp experiment basin scan_b.ply scan_a.ply --truth T.txt --distances 0,0.1,0.2 --report basin.html");
}

}  // namespace augicp::app
