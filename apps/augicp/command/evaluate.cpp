// SPDX-License-Identifier: MIT
#include "apps/augicp/command/evaluate.h"

#include <fmt/core.h>

#include <memory>
#include <stdexcept>
#include <utility>

#include "apps/augicp/command/exit_code.h"
#include "apps/augicp/command/output.h"
#include "apps/augicp/command/words.h"
#include "apps/augicp/text/evaluation.h"
#include "augicp/core/error.h"
#include "augicp/io/trajectory_file.h"

namespace augicp::app {
namespace {

struct EvaluateArguments {
  std::string estimate, truth, json;
  EvaluationOptions options;
  bool quiet = false;
};

Trajectory read_trajectory(const std::string& path) {
  TrajectoryFile file = read_tum_trajectory(path);
  for (const std::string& warning : file.warnings) fmt::print(stderr, "augicp: warning: {}: {}\n", path, warning);
  return std::move(file.trajectory);
}

// Options were checked: what is refused now is what the files say.
Evaluation evaluate_files(const EvaluateArguments& arguments) {
  const Trajectory estimate = read_trajectory(arguments.estimate), truth = read_trajectory(arguments.truth);
  try {
    return evaluate(estimate, truth, arguments.options);
  } catch (const std::invalid_argument& error) {
    throw IoError(fmt::format("{}, {}: {}", arguments.estimate, arguments.truth, error.what()));
  }
}

int run_evaluate(const EvaluateArguments& arguments) {
  arguments.options.check();
  const Evaluation evaluation = evaluate_files(arguments);
  if (!arguments.quiet && arguments.json != "-")
    fmt::print("estimate   {}\ntruth      {}\n{}", arguments.estimate, arguments.truth, evaluation_text(evaluation));
  if (arguments.json.empty()) return kSuccess;
  nlohmann::ordered_json json{{"estimate", arguments.estimate}, {"truth", arguments.truth}};
  json.update(evaluation_json(evaluation));
  json["version"] = AUGICP_VERSION;
  write_json(arguments.json, json);
  return kSuccess;
}

void add_matching_options(CLI::App& command, EvaluationOptions& options) {
  const std::string group = "Matching";
  command
      .add_option("--max-difference", options.association.max_difference_s,
                  "Stamps farther apart are not one moment, seconds")
      ->capture_default_str()
      ->group(group);
  command.add_option("--time-offset", options.association.time_offset_s, "Added to the estimate's stamps, seconds")
      ->capture_default_str()
      ->group(group);
  command
      .add_option("--truth", options.truth,
                  "The true pose: nearest in time, or interpolated at the estimate's stamp (default nearest)")
      ->transform(CLI::CheckedTransformer(kTruthReadings).description("{nearest,interpolated}"))
      ->group(group);
}

void add_error_options(CLI::App& command, EvaluationOptions& options) {
  const std::string group = "Errors";
  command
      .add_option("--align", options.alignment,
                  "How the estimate is laid on the truth for the second ATE (default rigid)")
      ->transform(CLI::CheckedTransformer(kAlignments).description("{none,origin,rigid,similarity}"))
      ->group(group);
  command.add_option("--delta", options.delta.delta, "RPE compares poses so far apart")
      ->capture_default_str()
      ->group(group);
  command.add_option("--unit", options.delta.unit, "What --delta counts (default frames: matched poses)")
      ->transform(CLI::CheckedTransformer(kDeltaUnits).description("{frames,seconds,metres}"))
      ->group(group);
  command
      .add_flag("--consecutive", options.delta.consecutive,
                "RPE pairs follow one another (default: one from every pose)")
      ->group(group);
}

}  // namespace

void add_evaluate_command(CLI::App& app, int& exit_code) {
  const auto arguments = std::make_shared<EvaluateArguments>();
  CLI::App* command = app.add_subcommand("evaluate", "Compare a trajectory with the true one: ATE and RPE");
  command->add_option("estimate,--estimate", arguments->estimate, "A trajectory: timestamp tx ty tz qx qy qz qw a line")
      ->required();
  command->add_option("groundtruth,--groundtruth", arguments->truth, "The true trajectory, in the same form")
      ->required();
  add_matching_options(*command, arguments->options);
  add_error_options(*command, arguments->options);
  command->add_option("--json", arguments->json, "Write all results as JSON to a file, or to stdout with -")
      ->group("Output");
  command->add_flag("--quiet", arguments->quiet, "Print nothing but errors")->group("Output");
  command->footer(
      "Poses are T_world_camera, stamps in seconds. ATE is told twice, with the worlds as they are and aligned.\n"
      "Examples:\n"
      "  augicp evaluate trajectory.txt groundtruth.txt\n"
      "  augicp evaluate trajectory.txt groundtruth.txt --delta 1 --unit seconds --json errors.json\n"
      "  augicp evaluate monocular.txt groundtruth.txt --align similarity --truth interpolated");
  command->callback([arguments, &exit_code] { exit_code = run_evaluate(*arguments); });
}

}  // namespace augicp::app
