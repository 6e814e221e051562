// SPDX-License-Identifier: MIT
// What `augicp odometry` is asked to do, and the options that say it.
#pragma once

#include <optional>
#include <string>

#include "apps/augicp/command/frame_range.h"
#include "apps/augicp/command/lidar_odometry.h"
#include "apps/augicp/command/progress.h"
#include "apps/augicp/command/sensor.h"
#include "augicp/odometry/odometry.h"

namespace CLI {
class App;
}

namespace augicp::app {

struct OdometryArguments {
  std::string sequence, topic, output, camera, json, page, mcap;
  Sensor sensor = Sensor::Auto;
  std::optional<double> depth_scale, readout_s;
  std::optional<double> frames_per_s;
  double time_offset_s = 0.0;
  FrameRange range;
  OdometryOptions odometry;
  LidarArguments lidar;
  Progress progress = Progress::Auto;
  bool quiet = false;
};

// All options of the subcommand, in their groups. The arguments must outlive the command.
void add_odometry_options(CLI::App& command, OdometryArguments& arguments);

}  // namespace augicp::app
