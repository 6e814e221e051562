// SPDX-License-Identifier: MIT
// `augicp odometry` on a folder of LiDAR scans.
#pragma once

#include <CLI/CLI.hpp>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "apps/augicp/command/point_times.h"
#include "apps/augicp/command/progress.h"
#include "apps/augicp/text/odometry.h"
#include "augicp/io/scan_sequence.h"
#include "augicp/odometry/lidar_odometry.h"

namespace augicp::app {

struct LidarArguments {
  std::string point_times = "auto";  // see point_times_of()
  std::string map;                   // a file for the map; empty: none
  std::optional<double> map_tile{};  // edge of the map's squares, metres; empty: squares only for large maps
  std::string mcap;                  // a file for poses, scans and map; empty: none
  LidarOptions odometry;
};

// The options that only LiDARs have.
void add_lidar_options(CLI::App& command, LidarArguments& arguments);

struct LidarInput {
  std::string name;  // of the folder, as it was given
  ScanSequence sequence;
  std::vector<std::size_t> chosen;  // numbers of its scans, ascending
  PointTimes point_times;
  std::filesystem::path output;  // a folder that exists
  // Called with each scan that could be read; may be empty.
  std::function<void(std::size_t row, const FrameReport& report, const Cloud& scan)> on_scan{};
  Progress progress = Progress::Auto;
  std::optional<double> max_memory_gb{};  // with the map that is written; see LidarOptions
};

// Tracks a LiDAR through a sequence of scans and writes trajectory.txt, poses_kitti.txt, frames.csv, covariances.csv
// and metrics.json, every few seconds and at the end, so that an interrupted run keeps them. A run
// whose memory does not suffice ends early, and keeps them as well. Throws TooMuchMemory for the first scan, IoError if
// no scan can be used, and std::invalid_argument.
OdometryRun run_lidar_odometry(const LidarInput& input, const LidarArguments& arguments);

}  // namespace augicp::app
