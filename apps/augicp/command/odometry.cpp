// SPDX-License-Identifier: MIT
#include "apps/augicp/command/odometry.h"

#include <fmt/core.h>

#include <algorithm>
#include <memory>
#include <optional>
#include <span>
#include <sstream>
#include <stdexcept>

#include "apps/augicp/command/inputs.h"
#include "apps/augicp/command/interruption.h"
#include "apps/augicp/command/lidar_odometry.h"
#include "apps/augicp/command/odometry_arguments.h"
#include "apps/augicp/command/odometry_input.h"
#include "apps/augicp/command/odometry_output.h"
#include "apps/augicp/command/output.h"
#include "apps/augicp/command/progress.h"
#include "apps/augicp/command/recording.h"
#include "apps/augicp/page/kept.h"
#include "apps/augicp/page/odometry_page.h"
#include "apps/augicp/text/odometry.h"
#include "augicp/core/check.h"
#include "augicp/io/atomic_file.h"
#include "augicp/io/bag_topics.h"
#include "augicp/io/depth_sequence.h"
#include "augicp/io/trajectory_file.h"
#include "augicp/odometry/track.h"

namespace augicp::app {
namespace {

namespace fs = std::filesystem;

// Options without meaning for the other kind of sensor.
constexpr const char* kDepthAlone[] = {"camera",           "depth-scale", "readout",           "reference",
                                       "pixel-step",       "min-depth",   "max-depth",         "min-overlap",
                                       "keyframe-overlap", "max-strain",  "max-extrapolation", "method",
                                       "max-iterations",   "time-offset"};
constexpr const char* kLidarAlone[] = {
    "point-times",           "pose-at", "map-voxel", "remove-seen-through", "check-every",
    "check-distance-voxels", "map",     "map-tile"};

DepthCamera camera_for(const DepthSequence& sequence, const OdometryArguments& arguments) {
  DepthCamera camera = sequence_camera(sequence, arguments.sequence, arguments.camera);
  camera.readout_s = arguments.readout_s.value_or(camera.readout_s);
  camera.check();
  return camera;
}

// The selected frames, each with its number in the sequence.
std::vector<FrameRow> chosen_frames(const DepthSequence& sequence, const OdometryArguments& arguments) {
  std::vector<FrameRow> rows;
  for (const std::size_t i : arguments.range.chosen(sequence.frames.size(), "frame"))
    rows.push_back({i, sequence.frames[i].path, {}, 0.0});
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
  run.warnings = sequence.warnings;
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

void set(CLI::App& command, const std::string& option, const std::string& value) {
  command.get_option(option)->clear();
  command.get_option(option)->add_result(value);
}

std::string in_numbers(const DepthCamera& camera) {
  const auto& [fx, fy, cx, cy, width, height] = camera.pinhole;
  const auto& [k1, k2, p1, p2, k3] = camera.distortion;
  return fmt::format("{} {} {} {} {} {} {} {} {}", fx, fy, cx, cy, k1, k2, p1, p2, k3);
}

bool is_among(const std::string& config_line, std::span<const char* const> options) {
  return std::any_of(options.begin(), options.end(),
                     [&](const char* option) { return config_line.starts_with(std::string(option) + "="); });
}

// Every option as it took effect, so that --config with this file repeats the run, from any folder. without: options
// of the other kind of sensor.
std::string effective_config(CLI::App& command, const fs::path& output, std::span<const char* const> without) {
  set(command, "--sequence", fs::absolute(command.get_option("--sequence")->as<std::string>()).string());
  set(command, "--output", fs::absolute(output).string());
  std::istringstream lines(command.config_to_str(/*default_also=*/true));
  std::string config = "[odometry]\n";
  for (std::string line; std::getline(lines, line);)  // empty: not given, and without a default
    if (!line.ends_with("=\"\"") && !is_among(line, without)) config += line + "\n";
  return config;
}

// Throws std::invalid_argument if an option is given that this kind of sensor would ignore.
void refuse(const CLI::App& command, std::span<const char* const> options, const std::string& sensor) {
  for (const char* option : options)
    if (command.get_option(std::string("--") + option)->count() > 0)
      throw std::invalid_argument(fmt::format("--{}: has no meaning for a {}", option, sensor));
}

std::string effective_config(CLI::App& command, const DepthSequence& sequence, const DepthCamera& camera,
                             const fs::path& output) {
  set(command, "--camera", in_numbers(camera));
  command.get_option("--depth-scale")->default_str(fmt::format("{}", sequence.depth_scale));
  command.get_option("--readout")->default_str(fmt::format("{}", camera.readout_s));
  return effective_config(command, output, kLidarAlone);
}

void write_page(const OdometryArguments& arguments, const OdometryPicture& picture) {
  if (arguments.page.empty()) return;
  StepLine line(arguments.quiet ? Progress::None : arguments.progress);
  line.show("report", "writing " + arguments.page);
  write_text_file(arguments.page, odometry_page(picture));
}

// in_folder: the folder and the files in it.
void report_to_user(const OdometryRun& run, const OdometryArguments& arguments, const std::string& in_folder) {
  if (arguments.json == "-") write_json("-", metrics_json(run));
  if (!run.ended_early.empty()) fmt::print(stderr, "augicp: {}\n", run.ended_early);
  const std::string files = written_text({in_folder, run.map_files, arguments.mcap}, arguments.page);
  if (!arguments.quiet && arguments.json != "-") fmt::print("{}output     {}\n", summary_text(run), files);
}

int run_lidar(const OdometryArguments& arguments, CLI::App& command, const std::optional<StampedTopic>& topic) {
  refuse(command, kDepthAlone, "LiDAR");
  arguments.lidar.odometry.check();
  require_extension(arguments.lidar.map, {".ply", ".pcd"}, "--map");
  if (arguments.lidar.map_tile) require_positive("--map-tile", *arguments.lidar.map_tile);  // NaN is in every range
  LidarInput input;
  input.name = arguments.sequence;
  input.sequence = scans_of(arguments, topic);
  print_warnings(input.sequence.warnings, arguments.quiet);
  input.chosen = arguments.range.chosen(input.sequence.scans.size(), "scan");
  input.point_times = point_times_of(input.sequence, input.chosen, arguments.lidar.point_times);
  input.progress = arguments.quiet ? Progress::None : arguments.progress;
  const OutputFolder made(arguments.output, arguments.sequence);
  const fs::path folder = input.output = made.path();
  const std::string config = effective_config(command, folder, kDepthAlone);
  write_text_file(folder / "config.toml", config);
  LidarArguments lidar = arguments.lidar;
  lidar.mcap = arguments.mcap;
  lidar.odometry.max_lost = arguments.odometry.max_lost;
  lidar.odometry.num_threads = arguments.odometry.registration.num_threads;
  input.max_memory_gb = lidar.odometry.max_memory_gb = arguments.odometry.registration.max_memory_gb;
  std::vector<KeptModel> scans;
  const std::vector<std::uint32_t> kept = kept_rows(arguments.page.empty() ? 0 : input.chosen.size());
  input.on_scan = [&](std::size_t row, const FrameReport& report, const Cloud& scan) {
    if (has_pose(report.status) && std::binary_search(kept.begin(), kept.end(), row))
      scans.push_back(kept_scan(row, report.world_from_camera, scan));
  };
  const OdometryRun run = run_lidar_odometry(input, lidar);
  if (run.rows.empty()) return run.interrupted_code;
  // A comment: given, the voxel size would change what counts as convincing.
  if (run.map_voxels && run.map_voxels->are_derived)
    write_text_file(folder / "config.toml", config + fmt::format("# map-voxel: {}\n", voxels_text(*run.map_voxels)));
  write_page(arguments, {run, scans});
  report_to_user(
      run, arguments,
      folder.string() + ": trajectory.txt poses_kitti.txt metrics.json frames.csv covariances.csv config.toml");
  return exit_code_for(run);
}

// By the first frame that can be read.
void warn_by_first_frame(const DepthSequence& sequence, double depth_scale) {
  for (const DepthFrameFile& frame : sequence.frames) try {
      return warn_of_depth_scale(read_depth_frame(frame, depth_scale), frame.path, depth_scale);
    } catch (const IoError&) {  // tracking reports it
    }
}

int run_odometry(const OdometryArguments& arguments, CLI::App& command) {
  require_sequence(arguments.sequence, arguments.topic);
  arguments.odometry.check();
  evaluation_options(arguments).check();
  require_extension(arguments.mcap, {".mcap"}, "--mcap");
  require_no_input_among({arguments.mcap, arguments.page, arguments.lidar.map}, {arguments.sequence});
  require_page_name(arguments.page);
  require_places({arguments.mcap, arguments.page, arguments.lidar.map},
                 output_folder(arguments.output, arguments.sequence));
  const std::optional<StampedTopic> topic = topic_of(arguments);
  if (is_lidar(arguments, topic)) return run_lidar(arguments, command, topic);
  refuse(command, kLidarAlone, "depth camera");
  const DepthSequence sequence = images_of(arguments, topic);
  print_warnings(sequence.warnings, arguments.quiet);
  const DepthCamera camera = camera_for(sequence, arguments);
  if (!arguments.quiet) warn_by_first_frame(sequence, arguments.depth_scale.value_or(sequence.depth_scale));
  const OutputFolder made(arguments.output, arguments.sequence);
  const fs::path& folder = made.path();
  // The options are written first, so that an unwritable folder costs no run.
  write_text_file(folder / "config.toml", effective_config(command, sequence, camera, folder));

  std::vector<KeptModel> models;
  const OdometryRun run = track_sequence(sequence, camera, arguments, models);
  require_readable(run, "image");
  write_whole([&] {
    write_tum_trajectory(folder / "trajectory.txt", trajectory_of(run));
    write_file(folder / "frames.csv", frames_csv(run));
    write_json((folder / "metrics.json").string(), metrics_json(run));
  });
  const double depth_scale = arguments.depth_scale.value_or(sequence.depth_scale);
  write_page(arguments, {run, models, &sequence, depth_scale});
  if (!arguments.mcap.empty()) write_depth_mcap(arguments.mcap, run, sequence, camera, depth_scale);
  report_to_user(run, arguments, folder.string() + ": trajectory.txt metrics.json frames.csv config.toml");
  return exit_code_for(run);
}

// The library's message on memory in the command's words.
int run_in_own_words(const OdometryArguments& arguments, CLI::App& command) {
  try {
    return run_odometry(arguments, command);
  } catch (const TooMuchMemory& error) {
    throw std::invalid_argument(error.message(kMemoryOptions));
  }
}

}  // namespace

void add_odometry_command(CLI::App& app, int& exit_code) {
  const auto arguments = std::make_shared<OdometryArguments>();
  CLI::App* command = app.add_subcommand(
      "odometry", "Track a depth camera or a LiDAR through a folder of images or scans, or a recording");
  add_odometry_options(*command, *arguments);
  command->footer(
      "trajectory.txt has T_world_camera in TUM format; the world is the frame of the first camera or scan.\n"
      "Examples:\n"
      "  augicp odometry rgbd_dataset_freiburg1_desk --camera tum-fr1 --output desk --report desk.html\n"
      "  augicp odometry dataset/sequences/00 --sensor lidar --map map.ply\n"
      "  augicp odometry drive.mcap --topic /lidar/points --map map.ply\n"
      "  augicp odometry chess/seq-01 --last 500\n"
      "  augicp odometry my_images --camera \"615 615 320 240\" --depth-scale 1000 --rate 15");
  command->callback([arguments, command, &exit_code] { exit_code = run_in_own_words(*arguments, *command); });
}

}  // namespace augicp::app
