// SPDX-License-Identifier: MIT
#include "apps/augicp/command/experiment_global.h"

#include <ctime>
#include <memory>
#include <stdexcept>

#include "apps/augicp/command/exit_code.h"
#include "apps/augicp/command/experiment_output.h"
#include "apps/augicp/command/global_inputs.h"
#include "apps/augicp/command/output.h"
#include "apps/augicp/command/table_options.h"
#include "apps/augicp/text/global.h"
#include "augicp/registration/option_table.h"

namespace augicp::app {
namespace {

struct GlobalArguments {
  std::vector<std::string> lists, folders, cameras;
  std::string table;
  std::string saved;
  bool apart = false;
  FragmentOptions fragments;
  GeneratedPairs generated;
  GlobalOptions options;
  ExperimentOutput output;
};

// A shared machine changes the wall time; with one thread the two are equal on an idle one.
double processor_ms() { return 1000.0 * static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

int run(const GlobalArguments& arguments) {
  GlobalInputs inputs;
  for (const std::string& list : arguments.lists) read_list(list, inputs);
  read_fragments(arguments.folders, arguments.cameras, arguments.fragments, inputs);
  if (arguments.apart) add_apart(inputs);
  add_generated(arguments.generated, inputs);
  if (inputs.pairs.empty()) throw std::invalid_argument("there is no pair: give --pairs, --sequences or --generated");
  if (!arguments.saved.empty()) save_pairs(arguments.saved, inputs.pairs);
  const auto count = inputs.pairs.size() * static_cast<std::size_t>(arguments.options.num_rotations);
  ProgressBar bar(count, "pairs", arguments.output.progress);
  const auto outcomes = run_global(inputs.pairs, arguments.options, processor_ms, [&] { bar.advance(); });
  if (!arguments.output.csv.empty()) write_text(arguments.output.csv, global_csv(outcomes));
  write_text(arguments.table.empty() ? "-" : arguments.table, global_text(summary(outcomes, arguments.options)));
  return kSuccess;
}

void add_inputs(CLI::App& command, GlobalArguments& arguments) {
  const std::string group = "Input";
  command
      .add_option("--pairs", arguments.lists,
                  "Lists with lines: family source target truth; truth: a 4x4 file, or - for clouds that share nothing")
      ->group(group);
  command.add_option("--sequences", arguments.folders, "Folders with depth images and true poses, fused to fragments")
      ->group(group);
  command.add_option("--camera", arguments.cameras, "One for all, or one per sequence; own: the folder's")
      ->delimiter(';')
      ->group(group);
  command.add_option("--frames", arguments.fragments.frames_each, "Images of a fragment")
      ->capture_default_str()
      ->group(group);
  command.add_option("--every", arguments.fragments.every, "Images between the begins of two fragments")
      ->capture_default_str()
      ->group(group);
  command.add_option("--time-offset", arguments.fragments.time_offset_s, "Read the truth at stamp + offset, seconds")
      ->capture_default_str()
      ->group(group);
  command.add_flag("--apart", arguments.apart, "Also all pairs of fragments of different sequences")->group(group);
  command.add_option("--generated", arguments.generated.count, "Generated pairs of each family")
      ->capture_default_str()
      ->group(group);
  command.add_option("--families", arguments.generated.families, "Names of generated families (default: all)")
      ->group(group);
  command.add_option("--first-seed", arguments.generated.first_seed, "Seed of the first generated pair of each family")
      ->capture_default_str()
      ->group(group);
  command.add_option("--rotations", arguments.options.num_rotations, "Random positions of each source")
      ->capture_default_str()
      ->group(group);
  command.add_option("--seed", arguments.options.seed, "Seed of these")->capture_default_str()->group(group);
}

}  // namespace

void add_global_experiment(CLI::App& experiment, int& exit_code) {
  const auto arguments = std::make_shared<GlobalArguments>();
  arguments->output.csv.clear();
  arguments->options.registration.global = true;
  CLI::App* command = experiment.add_subcommand("global", "How often a pose is found without a guess, and how well");
  add_inputs(*command, *arguments);
  add_options(*command, arguments->options.registration, {"threads", "search", "global_"});
  command->add_option("--output", arguments->output.csv, "Write a row per registration, CSV")->group("Output");
  command->add_option("--table", arguments->table, "Write a row per family to a file (default: stdout)")
      ->group("Output");
  command->add_option("--save", arguments->saved, "Write the clouds, true poses and a list of all pairs to a folder")
      ->group("Output");
  command->footer(
      "A pose is found within 30 cm and 15 degrees, and fine within 5 cm and 3 degrees; of generated objects within a\n"
      "tenth of these lengths. Times are the only numbers that differ from run to run.\n"
      "Examples:\n"
      "  augicp experiment global --pairs pairs.txt --rotations 10\n"
      "  augicp experiment global --sequences fr1_desk fr1_xyz --camera tum-fr1 --time-offset -0.022 --apart\n"
      "  augicp experiment global --generated 100 --families rooms \"rooms apart\"\n"
      "  augicp experiment global --sequences chess --camera own --output pairs.csv --table families.txt");
  command->callback([arguments, &exit_code] { exit_code = run(*arguments); });
}

}  // namespace augicp::app
