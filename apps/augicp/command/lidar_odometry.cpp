// SPDX-License-Identifier: MIT
#include "apps/augicp/command/lidar_odometry.h"

#include <fmt/core.h>

#include <limits>
#include <optional>

#include "apps/augicp/command/choice.h"
#include "apps/augicp/command/interruption.h"
#include "apps/augicp/command/odometry_output.h"
#include "apps/augicp/command/output.h"
#include "apps/augicp/command/recording.h"
#include "apps/augicp/command/scan_advice.h"
#include "apps/augicp/command/table_options.h"
#include "augicp/core/error.h"
#include "augicp/core/stop.h"
#include "augicp/io/atomic_file.h"
#include "augicp/io/trajectory_file.h"
#include "augicp/io/write_cloud.h"
#include "augicp/odometry/lidar_option_table.h"
#include "augicp/odometry/map_archive.h"

namespace augicp::app {
namespace {

namespace fs = std::filesystem;

constexpr double kSaveEvery_ms = 5000.0;

// A map with more points is written in tiles with edges of this length, metres.
constexpr std::size_t kMaxPointsOfAMap = 2'000'000;
constexpr double kTile = 100.0;
constexpr double kMinTile = 1.0, kMaxTile = 1e6;

FrameReport report_on(LidarOdometry& odometry, ScanReader& reader, const LidarInput& input, std::size_t row,
                      const std::stop_token& stop) {
  const std::size_t frame = input.chosen[row];
  const ScanFile& scan = input.sequence.scans[frame];
  try {
    const PointTimes& times = input.point_times;
    const CloudFile file = reader.read(frame, read_options_for(times));
    FrameReport report = odometry.add(scan.stamp_s, file.cloud, shares_of(file, scan.path, times), stop);
    if (input.on_scan) input.on_scan(row, report, file.cloud);
    return report;
  } catch (const IoError& error) {
    return unreadable_frame(scan.stamp_s, 0, error.what());
  }
}

// Twelve numbers a scan: the first three rows of its pose, or of the last known one if it has none.
std::string kitti_poses(const OdometryRun& run) {
  std::string text;
  Mat4d pose = Mat4d::Identity();
  for (const FrameRow& row : run.rows) {
    if (has_pose(row.report.status)) pose = row.report.world_from_camera.matrix();
    for (int i = 0; i < 12; ++i) text += fmt::format("{}{:.9g}", i == 0 ? "" : " ", pose(i / 4, i % 4));
    text += '\n';
  }
  return text;
}

// The upper triangle of each covariance, row by row: tx ty tz rx ry rz, metres and radians.
std::string covariances_csv(const OdometryRun& run) {
  std::string text = "frame";
  for (int i = 0; i < 6; ++i)
    for (int k = i; k < 6; ++k) text += fmt::format(",c{}{}", i, k);
  text += '\n';
  for (const FrameRow& row : run.rows) {
    if (!row.report.covariance) continue;
    text += std::to_string(row.frame);
    for (int i = 0; i < 6; ++i)
      for (int k = i; k < 6; ++k) text += fmt::format(",{:.6g}", (*row.report.covariance)(i, k));
    text += '\n';
  }
  return text;
}

void save(const OdometryRun& run, const fs::path& folder) {
  write_whole([&] {
    write_tum_trajectory(folder / "trajectory.txt", trajectory_of(run));
    write_file(folder / "poses_kitti.txt", kitti_poses(run));
    write_file(folder / "frames.csv", frames_csv(run));
    write_file(folder / "covariances.csv", covariances_csv(run));
    write_json((folder / "metrics.json").string(), metrics_json(run));
  });
}

// The map of the run so far, from what the odometry remembers.
void update(std::optional<MapArchive>& map, const LidarOdometry& odometry, const FrameReport& report, bool is_last) {
  if (!has_pose(report.status)) return;
  const Vec3d& place = report.world_from_camera.translation;
  if (!map) map.emplace(odometry.voxel_size(), odometry.reach());
  if (is_last || map->is_due(place)) map->update(odometry.map(), place);
}

// One file, or tiles, if they are wanted or the file would be large: one for each square, whose name ends in the
// square's number along x and y. Returns what was written, for people.
std::string write_map(const fs::path& path, const MapArchive& map, const std::optional<double>& wanted_tile) {
  const bool is_large = wanted_tile || map.size() > kMaxPointsOfAMap;
  const double edge = is_large ? wanted_tile.value_or(kTile) : std::numeric_limits<double>::infinity();
  const auto tiles = map.tiles(edge);
  for (const auto& [number, cloud] : tiles) {
    const std::string name =
        fmt::format("{}_{}_{}{}", path.stem().string(), number[0], number[1], path.extension().string());
    write_whole([&, &tile = cloud] { write_cloud(is_large ? path.parent_path() / name : path, tile); });
  }
  if (!is_large) return path.string();
  const std::string all = path.stem().string() + "_*" + path.extension().string();
  return fmt::format("{} ({} tiles)", (path.parent_path() / all).string(), tiles.size());
}

// A scan as its pose has it. Its times are left out: who deskewed it again would bend it.
CloudFile straight_scan(ScanReader& reader, const LidarInput& input, const FrameRow& row, PoseInstant pose_at) {
  CloudFile file = reader.read(row.frame, read_options_for(input.point_times));
  if (row.report.motion)
    file.cloud = deskewed(file.cloud, shares_of(file, row.image, input.point_times), row.report, pose_at);
  file.fields = {};
  return file;
}

void write_mcap(const fs::path& path, const OdometryRun& run, const LidarInput& input,
                const std::optional<MapArchive>& map, PoseInstant pose_at) {
  ScanReader reader(input.sequence);
  const bool is_mapped = map && map->size() > 0;
  const Cloud all = is_mapped ? map->tiles(std::numeric_limits<double>::infinity()).begin()->second : Cloud{};
  write_odometry_mcap(path, run, all, [&](const FrameRow& row) { return straight_scan(reader, input, row, pose_at); });
}

// Throws TooMuchMemory if the map that is to be written leaves no room.
void require_room(const MapArchive& map, const LidarOdometry& odometry, const std::optional<double>& max_memory_gb) {
  const double needed_gb = map.memory_gb() + odometry.memory_gb(), max_gb = allowed_gb(max_memory_gb);
  if (needed_gb <= max_gb) return;
  throw TooMuchMemory(fmt::format("the map of {} points and the odometry need about {:.2g} GB; {:.2g} GB are allowed",
                                  map.size(), needed_gb, max_gb),
                      {2.0 * odometry.voxel_size(), {}, {}});
}

OdometryRun track_scans(const LidarInput& input, LidarOdometry& odometry, std::optional<MapArchive>* map) {
  OdometryRun run{input.name, input.sequence.layout, {}, 0.0, {}, {}};
  run.point_times = input.point_times.in_words;
  run.warnings = input.sequence.warnings;
  ProgressBar bar(input.chosen.size(), "scans", input.progress);
  const Stopwatch all;
  double saved_ms = 0.0;
  ScanReader reader(input.sequence);
  const StopOnSignal signal;
  for (const std::size_t frame : input.chosen) {
    FrameRow row{frame, input.sequence.scans[frame].path, {}, 0.0};
    try {
      if (map && *map) require_room(**map, odometry, input.max_memory_gb);
      throw_if_stopped(signal.token());
      row.report = report_on(odometry, reader, input, run.rows.size(), signal.token());
    } catch (const TooMuchMemory& error) {
      if (run.rows.empty()) throw;  // nothing is done yet
      run.ended_early = fmt::format("ended before scan {}: {}", frame, error.message(kMemoryOptions));
    } catch (const Interrupted&) {
      run.ended_early = fmt::format("interrupted before scan {}; what was done is kept", frame);
    }
    if (!run.ended_early.empty()) {
      if (map && !run.rows.empty()) update(*map, odometry, run.rows.back().report, true);
      break;
    }
    if (row.report.status == FrameStatus::Unreadable && !run.rows.empty())
      row.report.segment = run.rows.back().report.segment;
    if (map) update(*map, odometry, row.report, frame == input.chosen.back());
    row.time_ms = all.elapsed_ms() - run.total_ms;
    run.total_ms = all.elapsed_ms();
    run.rows.push_back(std::move(row));
    bar.advance();
    if (odometry.voxel_size() > 0.0) run.map_voxels = MapVoxels{odometry.voxel_size(), odometry.derives_voxel_size()};
    if (run.total_ms < saved_ms + kSaveEvery_ms) continue;
    save(run, input.output);
    saved_ms = run.total_ms;
  }
  run.interrupted_code = signal.exit_code();
  return run;
}

// By the first scan that can be read.
std::string advice_on(const OdometryRun& run, const LidarInput& input) {
  ScanReader reader(input.sequence);
  for (const FrameRow& row : run.rows)
    if (row.report.status != FrameStatus::Unreadable) return scan_advice(reader.read(row.frame, {}).cloud);
  return "";
}

}  // namespace

void add_lidar_options(CLI::App& command, LidarArguments& arguments) {
  const std::string group = "LiDAR";
  command
      .add_option("--point-times", arguments.point_times,
                  "When the points of a sweep were measured: auto, azimuth, none (at once), or the name of a field")
      ->capture_default_str()
      ->group(group);
  command.add_option("--pose-at", arguments.odometry.pose_at, "The moment of a sweep to which its pose refers")
      ->default_str(std::string(name_of(arguments.odometry.pose_at)))
      ->transform(choice<PoseInstant>())
      ->group(group);
  command.add_option("--map-voxel", arguments.odometry.voxel_size, "Voxels of the map, metres (default: derived)")
      ->group(group);
  add_options(command, arguments.odometry, {"remove_seen_through", "check_every", "check_distance_voxels"});
  command.add_option("--map", arguments.map, "Write the map, .ply or .pcd")->group(group);
  command
      .add_option("--map-tile", arguments.map_tile,
                  "Write the map in squares with edges of this length, metres (default: in one file up to two million "
                  "points, else squares of 100 m)")
      ->check(CLI::Range(kMinTile, kMaxTile))
      ->group(group);
}

OdometryRun run_lidar_odometry(const LidarInput& input, const LidarArguments& arguments) {
  LidarOptions options = arguments.odometry;
  options.covariance = true;
  if (input.sequence.has_stamps) options.sweep_s = input.point_times.sweep_s;
  LidarOdometry odometry(options);
  std::optional<MapArchive> map;
  OdometryRun run = track_scans(input, odometry, arguments.map.empty() && arguments.mcap.empty() ? nullptr : &map);
  if (run.rows.empty()) return run;  // interrupted
  require_readable(run, "scan");
  if (!mostly_tracked(run)) run.advice = advice_on(run, input);
  save(run, input.output);
  if (!arguments.map.empty() && map && map->size() > 0)
    run.map_files = write_map(arguments.map, *map, arguments.map_tile);
  if (!arguments.mcap.empty()) write_mcap(arguments.mcap, run, input, map, options.pose_at);
  return run;
}

}  // namespace augicp::app
