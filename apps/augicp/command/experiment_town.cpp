// SPDX-License-Identifier: MIT
#include "apps/augicp/command/experiment_town.h"

#include <fmt/core.h>

#include <cmath>
#include <cstring>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>

#include "apps/augicp/command/exit_code.h"
#include "apps/augicp/command/interruption.h"
#include "apps/augicp/command/progress.h"
#include "augicp/core/error.h"
#include "augicp/io/atomic_file.h"
#include "augicp/io/trajectory_file.h"
#include "augicp/synthetic/town.h"

namespace augicp::app {
namespace {

namespace fs = std::filesystem;

struct TownArguments {
  std::string folder;
  synthetic::TownOptions town;
  synthetic::Lidar lidar;
  std::optional<std::size_t> num_sweeps;
  bool is_empty = false;  // without traffic
  Progress progress = Progress::Auto;
};

TownArguments defaults() {
  TownArguments arguments;
  arguments.lidar.range_sigma = 0.02;
  arguments.lidar.max_range = 80.0;
  return arguments;
}

void make_folder(const fs::path& path) {
  std::error_code error;
  fs::create_directories(path, error);
  if (error) throw IoError(path.string() + ": cannot be made: " + error.message());
}

// As KITTI has them: x y z and the return's strength, float32, little endian.
std::string kitti_bytes(const synthetic::Sweep& sweep) {
  const std::vector<float> strengths = reflectivities(sweep);
  std::string bytes(sweep.cloud.size() * 4 * sizeof(float), '\0');
  char* to = bytes.data();
  for (std::size_t i = 0; i < sweep.cloud.size(); ++i) {
    const Vec3f& point = sweep.cloud.points[i];
    for (const float value : {point.x(), point.y(), point.z(), strengths[i]}) {
      std::memcpy(to, &value, sizeof value);
      to += sizeof value;
    }
  }
  return bytes;
}

// The scans of a lap with one more than closes it, and the true poses at the middle of each sweep.
int run(const TownArguments& arguments) {
  const synthetic::TownLoop loop = town_loop(arguments.town);
  const double sweep_s = arguments.lidar.sweep_s;
  const std::size_t count =
      arguments.num_sweeps.value_or(static_cast<std::size_t>(std::ceil(loop.lap_s / sweep_s)) + 1);
  const fs::path folder = arguments.folder, scans = folder / "velodyne";
  make_folder(scans);
  ProgressBar bar(count, "scans", arguments.progress);
  const Rigid3 first_from_world = inverse(loop.world_from_sensor(0.5 * sweep_s));
  Trajectory truth;
  std::string times;
  for (std::size_t k = 0; k < count; ++k) {
    const double begin_s = static_cast<double>(k) * sweep_s;
    const unsigned seed = arguments.town.seed + static_cast<unsigned>(k);
    const synthetic::Sweep sweep = scan(loop.world, arguments.lidar, loop.world_from_sensor, seed, begin_s);
    write_whole([&] { write_file(scans / fmt::format("{:06}.bin", k), kitti_bytes(sweep)); });
    truth.push_back({begin_s, first_from_world * loop.world_from_sensor(begin_s + 0.5 * sweep_s)});
    times += fmt::format("{:.9g}\n", begin_s);
    bar.advance();
  }
  write_whole([&] {
    write_file(folder / "times.txt", times);
    write_tum_trajectory(folder / "groundtruth.txt", truth);
  });
  return kSuccess;
}

void add_town_options(CLI::App& command, TownArguments& arguments) {
  const auto add = [&](const char* group, const char* name, auto& value, const char* help) {
    command.add_option(name, value, help)->capture_default_str()->group(group);
  };
  command.add_option("folder,--folder", arguments.folder, "Folder for the scans, made if missing")->required();
  add("Town", "--length", arguments.town.length, "Length of the loop, metres");
  add("Town", "--speed", arguments.town.speed, "On straight roads, m/s; half of it in the curves");
  add("Town", "--seed", arguments.town.seed, "Of houses, cars and noise");
  command.add_flag("--no-traffic", arguments.is_empty, "Nothing moves but the sensor")->group("Town");
  add("LiDAR", "--rings", arguments.lidar.num_rings, "Number of rings");
  add("LiDAR", "--azimuths", arguments.lidar.num_azimuths, "Points of a ring");
  add("LiDAR", "--range-noise", arguments.lidar.range_sigma, "Standard deviation of ranges, metres");
  add("LiDAR", "--max-range", arguments.lidar.max_range, "Largest range, metres");
  command.add_option("--sweeps", arguments.num_sweeps, "Number of sweeps (default: of one lap)")->group("LiDAR");
  add_progress_option(command, arguments.progress);
}

}  // namespace

void add_town_experiment(CLI::App& experiment, int& exit_code) {
  const auto arguments = std::make_shared<TownArguments>(defaults());
  CLI::App* command = experiment.add_subcommand(
      "town", "Write the LiDAR scans of a drive around a generated block, with its true poses");
  add_town_options(*command, *arguments);
  command->footer(
      "velodyne/*.bin (KITTI, in firing order), times.txt (begin of each sweep), groundtruth.txt (TUM; at its "
      "middle).\n"
      "Examples:\n"
      "  augicp experiment town town && augicp odometry town --output run\n"
      "  augicp evaluate run/trajectory.txt town/groundtruth.txt --segments 100,200,300,400\n"
      "  augicp experiment town small --length 200 --sweeps 40 --rings 32");
  command->callback([arguments, &exit_code] {
    arguments->town.has_traffic = !arguments->is_empty;
    exit_code = run(*arguments);
  });
}

}  // namespace augicp::app
