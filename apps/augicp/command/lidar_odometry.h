// SPDX-License-Identifier: MIT
// `augicp odometry` on a folder of LiDAR scans.
#pragma once

#include <CLI/CLI.hpp>
#include <filesystem>
#include <string>
#include <vector>

#include "apps/augicp/command/progress.h"
#include "apps/augicp/text/odometry.h"
#include "augicp/core/words.h"
#include "augicp/io/scan_sequence.h"
#include "augicp/odometry/lidar_odometry.h"

namespace augicp::app {

// When the points of a sweep were measured.
enum class PointTimes { Auto, Azimuth, None };
}  // namespace augicp::app

namespace augicp {
template <>
inline constexpr auto kWords<app::PointTimes> = std::to_array<Word<app::PointTimes>>(
    {{app::PointTimes::Auto, "auto"}, {app::PointTimes::Azimuth, "azimuth"}, {app::PointTimes::None, "none"}});
}  // namespace augicp

namespace augicp::app {

struct LidarArguments {
  PointTimes point_times = PointTimes::Auto;
  std::string map;  // a file for the map; empty: none
  LidarOptions odometry;
};

// The options that only LiDARs have.
void add_lidar_options(CLI::App& command, LidarArguments& arguments);

struct LidarInput {
  std::string name;  // of the folder, as it was given
  ScanSequence sequence;
  std::vector<std::size_t> chosen;  // numbers of its scans, ascending
  std::filesystem::path output;     // a folder that exists
  Progress progress = Progress::Auto;
};

// Tracks a LiDAR through a sequence of scans and writes trajectory.txt, poses_kitti.txt, frames.csv, covariances.csv
// and metrics.json, every few seconds and at the end, so that an interrupted run keeps them. Throws IoError if no scan
// can be used, and std::invalid_argument.
OdometryRun run_lidar_odometry(const LidarInput& input, const LidarArguments& arguments);

}  // namespace augicp::app
