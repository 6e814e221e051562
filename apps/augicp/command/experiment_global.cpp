// SPDX-License-Identifier: MIT
#include "apps/augicp/command/experiment_global.h"

#include <ctime>
#include <deque>
#include <filesystem>
#include <fstream>
#include <memory>
#include <sstream>

#include "apps/augicp/command/exit_code.h"
#include "apps/augicp/command/experiment_output.h"
#include "apps/augicp/command/inputs.h"
#include "apps/augicp/command/output.h"
#include "apps/augicp/command/table_options.h"
#include "apps/augicp/text/global.h"
#include "augicp/core/error.h"
#include "augicp/io/read_cloud.h"
#include "augicp/io/transform_file.h"
#include "augicp/registration/option_table.h"

namespace augicp::app {
namespace {

struct GlobalArguments {
  std::vector<std::string> lists, folders, cameras;
  std::string table;
  bool apart = false;
  FragmentOptions fragments;
  GlobalOptions options;
  ExperimentOutput output;
};

// Clouds stay in place while pairs point to them.
struct GlobalInputs {
  std::deque<Cloud> clouds;
  std::deque<std::vector<Fragment>> fragments;
  std::vector<GlobalPair> pairs;
};

// Lines "family source target truth", paths relative to the list; truth is a file or - for clouds without common
// surface.
void read_list(const std::filesystem::path& list, GlobalInputs& inputs) {
  std::ifstream file(list);
  if (!file) throw IoError(list.string() + ": cannot be read");
  std::string line;
  for (int number = 1; std::getline(file, line); ++number) {
    std::istringstream words(line);
    std::string family, source, target, truth;
    if (!(words >> family) || family.front() == '#') continue;
    if (!(words >> source >> target >> truth))
      throw IoError(list.string() + ": line " + std::to_string(number) + ": expected family, source, target, truth");
    const auto folder = list.parent_path();
    GlobalPair pair{family, source, target, nullptr, nullptr, std::nullopt};
    pair.source = &inputs.clouds.emplace_back(read_cloud(folder / source).cloud);
    pair.target = &inputs.clouds.emplace_back(read_cloud(folder / target).cloud);
    if (truth != "-") pair.target_from_source = read_transform(folder / truth);
    inputs.pairs.push_back(pair);
  }
}

void read_fragments(const GlobalArguments& arguments, GlobalInputs& inputs) {
  const std::size_t num_cameras = arguments.cameras.size();
  if (num_cameras > 1 && num_cameras != arguments.folders.size())
    throw std::invalid_argument("--camera: give none, one, or one for each sequence");
  for (std::size_t k = 0; k < arguments.folders.size(); ++k) {
    const std::string& folder = arguments.folders[k];
    const std::string camera = num_cameras == 0 ? "" : arguments.cameras[num_cameras == 1 ? 0 : k];
    const DepthSequence sequence = read_depth_sequence(folder);
    const DepthCamera found = sequence_camera(sequence, folder, camera == "own" ? "" : camera);
    const auto& fragments = inputs.fragments.emplace_back(fragments_of(sequence, found, arguments.fragments));
    for (GlobalPair& pair : pairs_of_fragments("fragments", fragments, arguments.fragments.frames_each))
      inputs.pairs.push_back(std::move(pair));
  }
}

void add_apart(GlobalInputs& inputs) {
  for (std::size_t a = 0; a < inputs.fragments.size(); ++a)
    for (std::size_t b = a + 1; b < inputs.fragments.size(); ++b)
      for (const Fragment& target : inputs.fragments[a])
        for (const Fragment& source : inputs.fragments[b])
          inputs.pairs.push_back({"apart", std::to_string(b) + ":" + std::to_string(source.first_frame),
                                  std::to_string(a) + ":" + std::to_string(target.first_frame), &source.cloud,
                                  &target.cloud, std::nullopt});
}

// A shared machine changes the wall time; with one thread the two are equal on an idle one.
double processor_ms() { return 1000.0 * static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

int run(const GlobalArguments& arguments) {
  GlobalInputs inputs;
  for (const std::string& list : arguments.lists) read_list(list, inputs);
  read_fragments(arguments, inputs);
  if (arguments.apart) add_apart(inputs);
  if (inputs.pairs.empty()) throw std::invalid_argument("there is no pair: give --pairs or --sequences");
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
  command->footer(
      "A pose is found within 30 cm and 15 degrees, and fine within 5 cm and 3 degrees. Times are the only numbers "
      "that\n"
      "differ from run to run.\n"
      "Examples:\n"
      "  augicp experiment global --pairs pairs.txt --rotations 10\n"
      "  augicp experiment global --sequences fr1_desk fr1_xyz --camera tum-fr1 --time-offset -0.022 --apart\n"
      "  augicp experiment global --sequences chess --camera own --output pairs.csv --table families.txt");
  command->callback([arguments, &exit_code] { exit_code = run(*arguments); });
}

}  // namespace augicp::app
