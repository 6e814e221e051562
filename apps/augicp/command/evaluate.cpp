// SPDX-License-Identifier: MIT
#include "apps/augicp/command/evaluate.h"

#include <fmt/core.h>

#include <memory>
#include <stdexcept>
#include <utility>

#include "apps/augicp/command/exit_code.h"
#include "apps/augicp/command/output.h"
#include "apps/augicp/command/table_options.h"
#include "apps/augicp/text/evaluation.h"
#include "augicp/core/error.h"
#include "augicp/eval/option_table.h"
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

// Options were checked before: errors here concern the files.
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

}  // namespace

void add_evaluate_command(CLI::App& app, int& exit_code) {
  const auto arguments = std::make_shared<EvaluateArguments>();
  CLI::App* command = app.add_subcommand("evaluate", "Compare a trajectory with the true one: ATE and RPE");
  command->add_option("estimate,--estimate", arguments->estimate, "A trajectory: timestamp tx ty tz qx qy qz qw a line")
      ->required();
  command->add_option("groundtruth,--groundtruth", arguments->truth, "The true trajectory, in the same form")
      ->required();
  add_all_options(*command, arguments->options);
  command->add_option("--json", arguments->json, "Write all results as JSON to a file, or to stdout with -")
      ->group("Output");
  command->add_flag("--quiet", arguments->quiet, "Print errors only")->group("Output");
  command->footer(
      "Poses are T_world_camera, stamps in seconds. ATE is reported twice, not aligned and aligned.\n"
      "Examples:\n"
      "  augicp evaluate trajectory.txt groundtruth.txt\n"
      "  augicp evaluate trajectory.txt groundtruth.txt --delta 1 --unit seconds --json errors.json\n"
      "  augicp evaluate monocular.txt groundtruth.txt --align similarity --truth interpolated");
  command->callback([arguments, &exit_code] { exit_code = run_evaluate(*arguments); });
}

}  // namespace augicp::app
