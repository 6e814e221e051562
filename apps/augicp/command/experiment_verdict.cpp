// SPDX-License-Identifier: MIT
#include "apps/augicp/command/experiment_verdict.h"

#include <fmt/core.h>

#include <memory>
#include <stdexcept>

#include "apps/augicp/command/exit_code.h"
#include "apps/augicp/command/experiment_output.h"
#include "apps/augicp/command/inputs.h"
#include "apps/augicp/command/output.h"
#include "apps/augicp/command/table_options.h"
#include "apps/augicp/page/experiment_charts.h"
#include "apps/augicp/page/experiment_page.h"
#include "apps/augicp/text/verdict.h"
#include "augicp/registration/option_table.h"

namespace augicp::app {
namespace {

struct VerdictArguments {
  std::vector<std::string> folders, cameras;
  std::string table, roc;
  VerdictOptions options;
  ExperimentOutput output;
};

std::vector<VerdictSequence> read_sequences(const VerdictArguments& arguments) {
  const std::size_t num_cameras = arguments.cameras.size();
  if (num_cameras > 1 && num_cameras != arguments.folders.size())
    throw std::invalid_argument("--camera: give none, one, or one for each sequence");
  std::vector<VerdictSequence> sequences;
  for (std::size_t k = 0; k < arguments.folders.size(); ++k) {
    const std::string camera = num_cameras == 0 ? "" : arguments.cameras[num_cameras == 1 ? 0 : k];
    DepthSequence sequence = read_depth_sequence(arguments.folders[k]);
    const DepthCamera found = sequence_camera(sequence, arguments.folders[k], camera == "own" ? "" : camera);
    sequences.push_back({arguments.folders[k], std::move(sequence), found});
  }
  return sequences;
}

int run(const VerdictArguments& arguments) {
  const std::vector<VerdictSequence> sequences = read_sequences(arguments);
  ProgressBar bar(num_pairs(sequences, arguments.options), "pairs", arguments.output.progress);
  const std::vector<VerdictPair> pairs = run_verdict(sequences, arguments.options, [&] { bar.advance(); });
  if (!arguments.output.csv.empty()) write_text(arguments.output.csv, verdict_csv(pairs));
  write_text(arguments.table.empty() ? "-" : arguments.table, confusion_text(confusion(pairs)));
  if (!arguments.output.page.empty())
    write_text_file(arguments.output.page, experiment_page({"How often converged is right"}, verdict_quantities(pairs),
                                                           confusion_html(confusion(pairs))));
  if (!arguments.roc.empty()) write_text(arguments.roc, roc_csv(roc(pairs)));
  return kSuccess;
}

}  // namespace

void add_verdict_experiment(CLI::App& experiment, int& exit_code) {
  const auto arguments = std::make_shared<VerdictArguments>();
  arguments->output.csv.clear();
  VerdictOptions& options = arguments->options;
  CLI::App* command =
      experiment.add_subcommand("verdict", "How often `converged` is right, and how often it is withheld");
  command
      ->add_option("sequences,--sequences", arguments->folders, "Folders with depth images, each of a different place")
      ->required();
  command->add_option("--camera", arguments->cameras, "One for all, or one per sequence; own: the folder's")
      ->delimiter(';')
      ->group("Input");
  command->add_option("--gaps", options.gaps, "Pairs within a sequence with truth: frames apart")
      ->delimiter(',')
      ->capture_default_str()
      ->group("Input");
  command->add_option("--every", options.every, "Every N-th frame is a target")->capture_default_str()->group("Input");
  command->add_option("--across", options.num_across, "Number of pairs of different sequences")
      ->capture_default_str()
      ->group("Input");
  command->add_option("--seed", options.seed, "Seed of their choice")->capture_default_str()->group("Input");
  command->add_option("--pixel-step", options.pixel_step, "Use every N-th pixel and row")
      ->capture_default_str()
      ->group("Input");
  command->add_option("--time-offset", options.time_offset_s, "Read the truth at stamp + offset, seconds")
      ->capture_default_str()
      ->group("Input");
  command->add_flag("--as-clouds", options.as_clouds, "Ignore the cameras: bare points, nearest neighbours")
      ->group("Method");
  add_options(*command, options.registration, {"threads", "search", "coarse_to_fine", "rolling_shutter"});
  add_experiment_output(*command, arguments->output);
  command->add_option("--table", arguments->table, "Write the confusion table to a file (default: stdout)")
      ->group("Output");
  command->add_option("--roc", arguments->roc, "Write the results that other limits would accept and refuse, CSV")
      ->group("Output");
  command->footer(
      "Guess: identity. A result is right within 5 cm and 3 degrees, wrong beyond twice of either.\n"
      "Examples:\n"
      "  augicp experiment verdict rgbd_dataset_freiburg1_desk --camera tum-fr1 --time-offset -0.022 --roc roc.csv\n"
      "  augicp experiment verdict fr1_xyz chess --camera \"tum-fr1;own\" --across 1000 --output pairs.csv\n"
      "  augicp experiment verdict room_1 room_2 --gaps 1,7 --across 500 --report verdict.html");
  command->callback([arguments, &exit_code] { exit_code = run(*arguments); });
}

}  // namespace augicp::app
