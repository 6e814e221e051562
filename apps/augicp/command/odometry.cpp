// SPDX-License-Identifier: MIT
#include "apps/augicp/command/odometry.h"

#include <fmt/core.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <memory>
#include <optional>
#include <sstream>
#include <stdexcept>

#include "apps/augicp/command/choice.h"
#include "apps/augicp/command/exit_code.h"
#include "apps/augicp/command/inputs.h"
#include "apps/augicp/command/interruption.h"
#include "apps/augicp/command/output.h"
#include "apps/augicp/command/progress.h"
#include "apps/augicp/command/table_options.h"
#include "apps/augicp/page/kept.h"
#include "apps/augicp/page/odometry_page.h"
#include "apps/augicp/text/odometry.h"
#include "augicp/io/atomic_file.h"
#include "augicp/io/depth_sequence.h"
#include "augicp/io/trajectory_file.h"
#include "augicp/odometry/option_table.h"
#include "augicp/odometry/track.h"

namespace augicp::app {
namespace {

struct OdometryArguments {
  std::string sequence, output, camera, json, page;
  std::optional<double> depth_scale, readout_s;
  double frames_per_s = 30.0, time_offset_s = 0.0;
  std::size_t first = 0, last = std::size_t{1} << 40, every = 1;
  OdometryOptions odometry;
  Progress progress = Progress::Auto;
  bool quiet = false;
};

namespace fs = std::filesystem;

fs::path output_folder(const OdometryArguments& arguments) {
  if (!arguments.output.empty()) return arguments.output;
  const fs::path sequence = fs::path(arguments.sequence).lexically_normal();
  const fs::path name = sequence.has_filename() ? sequence.filename() : sequence.parent_path().filename();
  return (name.empty() || name == "." || name == ".." ? "sequence" : name.string()) + "_odometry";
}

DepthCamera camera_for(const DepthSequence& sequence, const OdometryArguments& arguments) {
  DepthCamera camera = sequence_camera(sequence, arguments.sequence, arguments.camera);
  camera.readout_s = arguments.readout_s.value_or(camera.readout_s);
  camera.check();
  return camera;
}

// The selected frames, each with its number in the sequence.
std::vector<FrameRow> chosen_frames(const DepthSequence& sequence, const OdometryArguments& arguments) {
  std::vector<FrameRow> rows;
  const std::size_t end = std::min(arguments.last, sequence.frames.size());
  for (std::size_t i = arguments.first; i < end; i += std::min(arguments.every, end - i))
    rows.push_back({i, sequence.frames[i].path, {}, 0.0});
  if (rows.empty())
    throw std::invalid_argument(fmt::format("--first {} --last {}: no frame of the sequence's {} is chosen",
                                            arguments.first, arguments.last, sequence.frames.size()));
  return rows;
}

EvaluationOptions evaluation_options(const OdometryArguments& arguments) {
  EvaluationOptions options;
  options.association.time_offset_s = arguments.time_offset_s;
  return options;
}

void compare_with_truth(const Trajectory& truth, const OdometryArguments& arguments, OdometryRun& run) {
  const Trajectory trajectory = trajectory_of(run);
  if (trajectory.empty()) return;
  try {
    run.evaluation = evaluate(trajectory, truth, evaluation_options(arguments));
  } catch (const std::invalid_argument& error) {
    run.evaluation_problem = error.what();
  }
}

// models: filled for the frames that the page keeps, if there is a page.
OdometryRun track_sequence(const DepthSequence& sequence, const DepthCamera& camera, const OdometryArguments& arguments,
                           std::vector<KeptModel>& models) {
  OdometryRun run{arguments.sequence,    sequence.layout, chosen_frames(sequence, arguments), 0.0, {},
                  sequence.truth_problem};
  std::vector<DepthFrameFile> files;
  for (const FrameRow& row : run.rows) files.push_back(sequence.frames[row.frame]);
  DepthSequenceReader reader(std::move(files), arguments.depth_scale.value_or(sequence.depth_scale));
  ProgressBar bar(run.rows.size(), "frames", arguments.quiet ? Progress::None : arguments.progress);
  const std::vector<std::uint32_t> kept = kept_rows(arguments.page.empty() ? 0 : run.rows.size());
  const Stopwatch all;
  std::size_t num_done = 0;
  track(reader, camera, arguments.odometry, [&](const FrameReport& report, const Odometry& odometry) {
    if (std::binary_search(kept.begin(), kept.end(), num_done)) models.push_back(kept_model(num_done, odometry));
    FrameRow& row = run.rows[num_done++];
    row.report = report;
    row.time_ms = all.elapsed_ms() - run.total_ms;
    run.total_ms = all.elapsed_ms();
    bar.advance();
  });
  if (sequence.truth) compare_with_truth(*sequence.truth, arguments, run);
  return run;
}

ExitCode exit_code_for(const OdometryRun& run) {
  const Trajectory trajectory = trajectory_of(run);
  if (trajectory.empty() || (trajectory.size() == 1 && run.rows.size() > 1)) return kRegistrationFailed;
  return num_segments(run) > 1 || !mostly_tracked(run) ? kDoubtful : kSuccess;
}

// If every image is refused, the images are not the reason.
void require_readable_frames(const OdometryRun& run) {
  const auto is_unreadable = [](const FrameRow& row) { return row.report.status == FrameStatus::Unreadable; };
  if (std::all_of(run.rows.begin(), run.rows.end(), is_unreadable))
    throw IoError("no image can be used; the first: " + run.rows.front().report.problem);
}

void set(CLI::App& command, const std::string& option, const std::string& value) {
  command.get_option(option)->clear();
  command.get_option(option)->add_result(value);
}

std::string in_numbers(const DepthCamera& camera) {
  const auto& [fx, fy, cx, cy, width, height] = camera.pinhole;
  const auto& [k1, k2, p1, p2, k3] = camera.distortion;
  return fmt::format("{} {} {} {} {} {} {} {} {}", fx, fy, cx, cy, k1, k2, p1, p2, k3);
}

// Every option as it took effect, so that --config with this file repeats the run, from any folder.
std::string effective_config(CLI::App& command, const DepthSequence& sequence, const DepthCamera& camera,
                             const fs::path& output) {
  set(command, "--sequence", fs::absolute(command.get_option("--sequence")->as<std::string>()).string());
  set(command, "--output", fs::absolute(output).string());
  set(command, "--camera", in_numbers(camera));
  command.get_option("--depth-scale")->default_str(fmt::format("{}", sequence.depth_scale));
  command.get_option("--readout")->default_str(fmt::format("{}", camera.readout_s));
  std::istringstream lines(command.config_to_str(/*default_also=*/true));
  std::string config = "[odometry]\n";
  for (std::string line; std::getline(lines, line);)
    if (!line.ends_with("=\"\"")) config += line + "\n";  // not given, and without a default
  return config;
}

int run_odometry(const OdometryArguments& arguments, CLI::App& command) {
  arguments.odometry.check();
  evaluation_options(arguments).check();
  const DepthSequence sequence = read_depth_sequence(arguments.sequence, arguments.frames_per_s);
  const DepthCamera camera = camera_for(sequence, arguments);
  const fs::path folder = output_folder(arguments);
  std::error_code error;
  fs::create_directories(folder, error);
  if (error) throw IoError(folder.string() + ": cannot be made: " + error.message());
  const std::string config = effective_config(command, sequence, camera, folder);
  write_text_file(folder / "config.toml", config);
  // The options are written first, so that an unwritable folder costs no run. Results of another run are removed.
  for (const char* name : {"trajectory.txt", "frames.csv", "metrics.json"}) fs::remove(folder / name, error);

  std::vector<KeptModel> models;
  const OdometryRun run = track_sequence(sequence, camera, arguments, models);
  require_readable_frames(run);
  write_whole([&] {
    write_tum_trajectory(folder / "trajectory.txt", trajectory_of(run));
    write_file(folder / "frames.csv", frames_csv(run));
    write_json((folder / "metrics.json").string(), metrics_json(run));
  });
  const double depth_scale = arguments.depth_scale.value_or(sequence.depth_scale);
  if (!arguments.page.empty()) write_text_file(arguments.page, odometry_page({run, sequence, depth_scale, models}));
  if (arguments.json == "-") write_json("-", metrics_json(run));
  if (!arguments.quiet && arguments.json != "-")
    fmt::print("{}output     {}: trajectory.txt metrics.json frames.csv config.toml\n", summary_text(run),
               folder.string());
  return exit_code_for(run);
}

void add_sequence_options(CLI::App& command, OdometryArguments& arguments) {
  const std::string group = "Input";
  command
      .add_option("--camera", arguments.camera,
                  fmt::format("A file, numbers \"fx fy cx cy [k1 k2 p1 p2 k3]\", or one of {} (default: the folder's)",
                              fmt::join(camera_names(), " ")))
      ->group(group);
  command
      .add_option("--depth-scale", arguments.depth_scale, "Pixel value of one metre (default: TUM 5000, others 1000)")
      ->group(group);
  command
      .add_option("--readout", arguments.readout_s,
                  "Rolling shutter: seconds from the first row to the last (default: the camera's; 0: none)")
      ->group(group);
  command.add_option("--rate", arguments.frames_per_s, "Frames per second, if the folder has no time stamps")
      ->capture_default_str()
      ->group(group);
  command.add_option("--first", arguments.first, "The first frame, counted from 0")
      ->capture_default_str()
      ->group(group);
  command.add_option("--last", arguments.last, "The frame to stop before (default: all)")->group(group);
  command.add_option("--every", arguments.every, "Use every N-th frame")
      ->check(CLI::Range(1, 1'000'000'000))
      ->capture_default_str()
      ->group(group);
}

void add_method_options(CLI::App& command, OdometryOptions& options) {
  add_options(command, options,
              {"reference", "pixel_step", "min_depth", "max_depth", "min_overlap", "keyframe_overlap", "max_strain",
               "max_lost", "max_extrapolation_s", "method", "max_iterations", "threads"});
}

void add_output_options(CLI::App& command, OdometryArguments& arguments) {
  const std::string group = "Output";
  command.add_option("--output", arguments.output, "Folder for the results, made if missing (default: NAME_odometry)")
      ->group(group);
  command.add_option("--time-offset", arguments.time_offset_s, "Read the truth at stamp + offset, seconds")
      ->capture_default_str()
      ->group(group);
  command.add_option("--report", arguments.page, "Write a report: one HTML file, readable offline")->group(group);
  command.add_option("--json", arguments.json, "With -: print metrics.json to stdout")
      ->check(CLI::IsMember({"-"}))
      ->group(group);
  command.add_option("--progress", arguments.progress, "A bar with the frame rate on stderr, if that is a terminal")
      ->default_str("auto")
      ->transform(choice<Progress>())
      ->group(group);
  command.add_flag("--quiet", arguments.quiet, "Print errors only")->group(group);
}

}  // namespace

void add_odometry_command(CLI::App& app, int& exit_code) {
  const auto arguments = std::make_shared<OdometryArguments>();
  CLI::App* command = app.add_subcommand("odometry", "Track a depth camera through a folder of images");
  command
      ->add_option("sequence,--sequence", arguments->sequence,
                   "A folder: TUM (depth.txt), 7-Scenes (frame-000000.depth.png), or numbered .png images")
      ->required();
  add_sequence_options(*command, *arguments);
  add_method_options(*command, arguments->odometry);
  add_output_options(*command, *arguments);
  command->footer(
      "trajectory.txt has T_world_camera in TUM format; the world is the frame of the first camera.\n"
      "Examples:\n"
      "  augicp odometry rgbd_dataset_freiburg1_desk --camera tum-fr1 --output desk --report desk.html\n"
      "  augicp odometry chess/seq-01 --last 500\n"
      "  augicp odometry my_images --camera \"615 615 320 240\" --depth-scale 1000 --rate 15");
  command->callback([arguments, command, &exit_code] { exit_code = run_odometry(*arguments, *command); });
}

}  // namespace augicp::app
