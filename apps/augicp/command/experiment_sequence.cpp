// SPDX-License-Identifier: MIT
#include "apps/augicp/command/experiment_sequence.h"

#include <fmt/core.h>

#include <cmath>
#include <memory>
#include <stdexcept>

#include "apps/augicp/command/choice.h"
#include "apps/augicp/command/exit_code.h"
#include "apps/augicp/command/experiment_output.h"
#include "apps/augicp/command/inputs.h"
#include "apps/augicp/command/output.h"
#include "apps/augicp/command/table_options.h"
#include "apps/augicp/page/experiment_charts.h"
#include "apps/augicp/page/experiment_page.h"
#include "apps/augicp/text/experiment.h"
#include "augicp/core/error.h"
#include "augicp/io/parse_number.h"
#include "augicp/registration/option_table.h"

namespace augicp::app {
namespace {

constexpr const char* kFoundOffset = "auto";

struct SequenceArguments {
  std::string folder, camera, curves;
  std::optional<double> depth_scale;
  std::vector<std::string> time_offsets{"0"};
  bool from_truth = false;
  SequenceOptions options;
  ExperimentOutput output;
};

double measured_offset(const DepthSequence& sequence, const DepthCamera& camera, const SequenceArguments& arguments) {
  const SequenceOptions options = time_offset_options(arguments.options);
  ProgressBar bar(chosen_targets(sequence.frames.size(), options).size(), "pairs", arguments.output.progress);
  const auto curves = run_sequence(sequence, camera, options, [&] { bar.advance(); });
  const TimeOffset found = find_time_offset(curves, *sequence.truth);
  fmt::print(stderr, "{}", time_offset_text(found));
  return found.offset_s;
}

std::vector<double> offsets_s(const DepthSequence& sequence, const DepthCamera& camera,
                              const SequenceArguments& arguments) {
  std::vector<double> offsets;
  for (const std::string& word : arguments.time_offsets) {
    const auto number = parse_double(word);
    if (word != kFoundOffset && !(number && std::isfinite(*number)))
      throw std::invalid_argument("--time-offset " + word + ": must be seconds or auto");
    offsets.push_back(number ? *number : measured_offset(sequence, camera, arguments));
  }
  return offsets;
}

int run(const SequenceArguments& arguments) {
  arguments.options.check();
  DepthSequence sequence = read_depth_sequence(arguments.folder);
  sequence.depth_scale = arguments.depth_scale.value_or(sequence.depth_scale);
  if (!sequence.truth) throw IoError(arguments.folder + ": expected a true trajectory, groundtruth.txt, found none");
  const DepthCamera camera = sequence_camera(sequence, arguments.folder, arguments.camera);
  const std::vector<double> offsets = offsets_s(sequence, camera, arguments);
  SequenceOptions options = arguments.options;
  if (arguments.from_truth) options.guess = {*sequence.truth, offsets.front()};
  ProgressBar bar(chosen_targets(sequence.frames.size(), options).size(), "targets", arguments.output.progress);
  const auto curves = run_sequence(sequence, camera, options, [&] { bar.advance(); });
  write_text(arguments.output.csv, sequence_csv(curves, *sequence.truth, offsets));
  if (!arguments.output.page.empty())
    write_text_file(arguments.output.page,
                    experiment_page({"Pairs of a sequence, by iteration", "Sequence: " + arguments.folder},
                                    sequence_quantities(curves, *sequence.truth, offsets)));
  if (!arguments.curves.empty()) write_text(arguments.curves, curves_csv(curves, *sequence.truth, offsets));
  return kSuccess;
}

void add_input(CLI::App& command, SequenceArguments& arguments) {
  SequenceOptions& options = arguments.options;
  const std::string group = "Input";
  command
      .add_option("--camera", arguments.camera,
                  "A file, a name or numbers, as in `augicp odometry` (default: the folder's)")
      ->group(group);
  command.add_option("--depth-scale", arguments.depth_scale, "Pixel value of one metre (default: the layout's)")
      ->group(group);
  command.add_option("--gaps", options.gaps, "Frames from target to source")
      ->delimiter(',')
      ->capture_default_str()
      ->group(group);
  command.add_option("--every", options.every, "Every N-th frame is a target")->capture_default_str()->group(group);
  command.add_option("--pairs", options.max_targets, "Largest number of targets, evenly spread (default: all)")
      ->group(group);
  command.add_option("--pixel-step", options.pixel_step, "Use every N-th pixel and row")
      ->capture_default_str()
      ->group(group);
  command
      .add_option("--time-offset", arguments.time_offsets,
                  "Truth is read at stamp + offset: seconds, or auto: found from registrations; several: rows for each")
      ->delimiter(',')
      ->capture_default_str()
      ->group(group);
  command
      .add_flag("--from-truth", arguments.from_truth,
                "Start at the true motion, at the first offset, not at the identity")
      ->group(group);
}

void add_method(CLI::App& command, SequenceOptions& options) {
  const std::string group = "Method";
  command.add_option("--presets", options.presets, "Any of default,paper (default both)")
      ->delimiter(',')
      ->transform(choice<Preset>())
      ->group(group);
  command.add_option("--methods", options.methods, "Any of augmented,gicp,plane,point,ndt (default all)")
      ->delimiter(',')
      ->transform(choice<Method>())
      ->group(group);
  command
      .add_option("--surroundings", options.surroundings,
                  "Surfaces from: window of 3D size (default), square of pixels as in the paper, exact ball (slow)")
      ->transform(choice<Surroundings>())
      ->group(group);
  command.add_option("--iterations", options.iterations, "Exact number of iterations")
      ->capture_default_str()
      ->group(group);
}

}  // namespace

void add_sequence_experiment(CLI::App& experiment, int& exit_code) {
  const auto arguments = std::make_shared<SequenceArguments>();
  CLI::App* command =
      experiment.add_subcommand("sequence", "Pairs of a sequence some frames apart (the paper's Table 3)");
  command->add_option("sequence,--sequence", arguments->folder, "A folder with depth images and their true trajectory")
      ->required();
  add_input(*command, *arguments);
  add_method(*command, arguments->options);
  add_options(*command, arguments->options.registration,
              {"radius", "threads", "classifier", "kernel_chi2", "lever", "damping", "search", "coarse_to_fine",
               "rolling_shutter"});
  add_experiment_output(*command, arguments->output);
  command->add_option("--curves", arguments->curves, "Write the errors of every single registration as CSV")
      ->group("Output");
  command->footer(
      "Guess: identity. Success is within 5 cm and 2 degrees, narrow success within 2 cm and 1 degree.\n"
      "Examples:\n"
      "  augicp experiment sequence rgbd_dataset_freiburg1_desk --camera tum-fr1 --output table3.csv --report "
      "table3.html\n"
      "  augicp experiment sequence rgbd_dataset_freiburg1_360 --camera tum-fr1 --pairs 30 --time-offset 0,auto\n"
      "  augicp experiment sequence chess/seq-01 --gaps 10 --presets paper --lever 0.2 --curves curves.csv");
  command->callback([arguments, &exit_code] { exit_code = run(*arguments); });
}

}  // namespace augicp::app
