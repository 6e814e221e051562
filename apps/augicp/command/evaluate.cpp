// SPDX-License-Identifier: MIT
#include "apps/augicp/command/evaluate.h"

#include <fmt/core.h>

#include <memory>
#include <span>
#include <stdexcept>
#include <vector>

#include "apps/augicp/command/exit_code.h"
#include "apps/augicp/command/inputs.h"
#include "apps/augicp/command/output.h"
#include "apps/augicp/command/table_options.h"
#include "apps/augicp/page/evaluation_page.h"
#include "apps/augicp/text/drift.h"
#include "apps/augicp/text/evaluation.h"
#include "augicp/core/error.h"
#include "augicp/eval/option_table.h"
#include "augicp/io/file_bytes.h"
#include "augicp/io/pose_file.h"
#include "augicp/io/reference_pairs_file.h"

namespace augicp::app {
namespace {

struct EvaluateArguments {
  std::string estimate, truth, pairs, json, page;
  std::vector<std::string> others;  // further estimates
  EvaluationOptions options;
  bool quiet = false;
};

PoseFile read_and_warn(const std::string& path) {
  for (const char* const of_cloud : {".ply", ".pcd", ".las", ".laz", ".stl", ".obj", ".png"})
    if (lower_case_extension(path) == of_cloud)
      throw IoError(path +
                    ": expected a trajectory, found a name of a cloud or image; clouds are registered by: "
                    "augicp align SOURCE TARGET");
  PoseFile file = read_poses(path);
  for (const std::string& warning : file.content.warnings)
    fmt::print(stderr, "augicp: warning: {}: {}\n", path, warning);
  return file;
}

// Options were checked before: errors here concern the files.
EvaluatedRun evaluate_files(const std::string& path, PoseFile estimate, PoseFile truth,
                            const EvaluateArguments& arguments) {
  share_stamps(estimate, truth);
  if (estimate.has_stamps != truth.has_stamps)
    throw IoError(fmt::format("{}, {}: only one has timestamps, and they have {} and {} poses", path, arguments.truth,
                              estimate.content.trajectory.size(), truth.content.trajectory.size()));
  EvaluatedRun run{path, std::move(estimate.content.trajectory), std::move(truth.content.trajectory), {}};
  try {
    run.evaluation = evaluate(run.estimate, run.truth, arguments.options);
  } catch (const std::invalid_argument& error) {
    throw IoError(fmt::format("{}, {}: {}", path, arguments.truth, error.what()));
  }
  for (const std::string& warning : coverage_warnings(run.evaluation.coverage))
    fmt::print(stderr, "augicp: warning: {}: {}\n", path, warning);
  return run;
}

std::vector<GapError> errors_of(const PoseFile& estimate, std::span<const ReferencePair> known) {
  std::vector<Rigid3> poses;
  for (const StampedPose& pose : estimate.content.trajectory) poses.push_back(pose.world_from_camera);
  return errors_by_gap(pair_errors(poses, known));
}

// runs: takes what a report draws.
Compared compared(const std::string& path, const EvaluateArguments& arguments, std::span<const ReferencePair> known,
                  std::vector<EvaluatedRun>& runs) {
  Compared result{path, {}, {}, 0, 0};
  PoseFile estimate = read_and_warn(path);
  if (!arguments.pairs.empty()) result.of_gap = errors_of(estimate, known);
  result.num_repeated_estimate = estimate.content.num_repeated;
  if (arguments.truth.empty()) return result;
  PoseFile truth = read_and_warn(arguments.truth);
  result.num_repeated_truth = truth.content.num_repeated;
  runs.push_back(evaluate_files(path, std::move(estimate), std::move(truth), arguments));
  result.evaluation = runs.back().evaluation;
  return result;
}

std::string text_of(std::span<const Compared> all, const EvaluateArguments& arguments, std::size_t num_known) {
  if (all.size() > 1) return comparison_text(all);
  std::string text = fmt::format("estimate   {}\n", arguments.estimate);
  if (all[0].evaluation) text += fmt::format("truth      {}\n{}", arguments.truth, evaluation_text(*all[0].evaluation));
  if (all[0].of_gap) text += (all[0].evaluation ? "\n" : "") + gaps_text(*all[0].of_gap, num_known);
  return text;
}

nlohmann::ordered_json json_of(const Compared& result, const EvaluateArguments& arguments) {
  nlohmann::ordered_json json{{"estimate", result.estimate}};
  if (result.evaluation) {
    json["truth"] = arguments.truth;
    json.update(evaluation_json(*result.evaluation));
    json["num_repeated_truth"] = result.num_repeated_truth;
  }
  json["num_repeated_estimate"] = result.num_repeated_estimate;
  if (result.of_gap) json["pairs"] = gaps_json(*result.of_gap);
  return json;
}

std::vector<std::string> inputs_of(const EvaluateArguments& arguments) {
  std::vector<std::string> all = arguments.others;
  all.insert(all.end(), {arguments.estimate, arguments.truth, arguments.pairs});
  return all;
}

int run_evaluate(const EvaluateArguments& arguments) {
  arguments.options.check();
  if (arguments.truth.empty() && arguments.pairs.empty())
    throw std::invalid_argument("groundtruth is required, or --pairs");
  if (arguments.truth.empty() && !arguments.page.empty()) throw std::invalid_argument("--report: needs groundtruth");
  require_no_input_among({arguments.json, arguments.page}, inputs_of(arguments));
  require_page_name(arguments.page);
  require_places({arguments.json, arguments.page});
  std::vector<ReferencePair> known;
  if (!arguments.pairs.empty()) known = read_reference_pairs(arguments.pairs);
  std::vector<EvaluatedRun> runs;
  std::vector<Compared> all{compared(arguments.estimate, arguments, known, runs)};
  for (const std::string& other : arguments.others) all.push_back(compared(other, arguments, known, runs));
  if (!arguments.quiet && arguments.json != "-") fmt::print("{}", text_of(all, arguments, known.size()));
  if (!arguments.page.empty()) write_text_file(arguments.page, evaluation_page(arguments.truth, runs));
  if (!arguments.json.empty()) {
    nlohmann::ordered_json json = json_of(all[0], arguments);
    for (std::size_t i = 1; i < all.size(); ++i) json["others"].push_back(json_of(all[i], arguments));
    json["version"] = AUGICP_VERSION;
    write_json(arguments.json, json);
  }
  const std::string written = written_text({arguments.json}, arguments.page);
  if (!arguments.quiet && arguments.json != "-" && !written.empty()) fmt::print("written    {}\n", written);
  return kSuccess;
}

}  // namespace

void add_evaluate_command(CLI::App& app, int& exit_code) {
  const auto arguments = std::make_shared<EvaluateArguments>();
  CLI::App* command = app.add_subcommand("evaluate", "Compare trajectories with the true one: ATE, RPE and drift");
  command
      ->add_option("estimate,--estimate", arguments->estimate,
                   "A trajectory: timestamp tx ty tz qx qy qz qw a line, or KITTI's 12 numbers")
      ->required();
  command->add_option("groundtruth,--groundtruth", arguments->truth, "The true trajectory, in any of these forms");
  command->add_option("--beside", arguments->others, "Further estimates, compared in one table")->group("Input");
  command->add_option("--pairs", arguments->pairs, "Known motions: i j tx ty tz qx qy qz qw a line, poses from 0")
      ->group("Input");
  command
      ->add_option("--segments", arguments->options.segments.lengths,
                   "Lengths of the segments of KITTI's error, metres, separated by commas")
      ->delimiter(',')
      ->group("Errors");
  add_all_options(*command, arguments->options);
  command->add_option("--json", arguments->json, "Write all results as JSON to a file, or to stdout with -")
      ->group("Output");
  command
      ->add_option("--report", arguments->page,
                   "Write a report: one HTML file with all estimates over the ground truth in 3D, readable offline")
      ->group("Output");
  command->add_flag("--quiet", arguments->quiet, "Print errors only")->group("Output");
  command->footer(
      "Poses are T_world_camera, stamps in seconds. ATE is reported twice, not aligned and aligned.\n"
      "Examples:\n"
      "  augicp evaluate trajectory.txt groundtruth.txt\n"
      "  augicp evaluate trajectory.txt groundtruth.txt --delta 1 --unit seconds --json errors.json\n"
      "  augicp evaluate monocular.txt groundtruth.txt --align similarity --truth interpolated\n"
      "  augicp evaluate poses_kitti.txt 00.txt --segments 10,20,50 --beside other.txt --report runs.html");
  command->callback([arguments, &exit_code] { exit_code = run_evaluate(*arguments); });
}

}  // namespace augicp::app
