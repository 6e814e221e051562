// SPDX-License-Identifier: MIT
#include "apps/augicp/command/odometry_arguments.h"

#include <fmt/core.h>
#include <fmt/ranges.h>

#include "apps/augicp/command/choice.h"
#include "apps/augicp/command/inputs.h"
#include "apps/augicp/command/output.h"
#include "apps/augicp/command/recording.h"
#include "apps/augicp/command/table_options.h"
#include "augicp/odometry/option_table.h"

namespace augicp::app {
namespace {

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
  command
      .add_option("--rate", arguments.frames_per_s,
                  "Frames per second, if the folder has no time stamps (default: 30; LiDAR 10)")
      ->group(group);
  command.add_option("--sensor", arguments.sensor, "depth, lidar, or auto: by the files in the folder")
      ->default_str("auto")
      ->transform(choice<Sensor>())
      ->group(group);
  command
      .add_option("--topic", arguments.topic,
                  "Of a recording: which clouds or depth images (default: the only ones; augicp info lists them)")
      ->group(group);
  add_range_options(command, arguments.range, group);
}

void add_method_options(CLI::App& command, OdometryOptions& options) {
  add_options(command, options,
              {"reference", "pixel_step", "min_depth", "max_depth", "min_overlap", "keyframe_overlap", "max_strain",
               "max_lost", "max_extrapolation_s", "method", "max_iterations", "threads", "max_memory_gb"});
}

void add_output_options(CLI::App& command, OdometryArguments& arguments) {
  const std::string group = "Output";
  command.add_option("--output", arguments.output, "Folder for the results, made if missing (default: NAME_odometry)")
      ->group(group);
  command.add_option("--time-offset", arguments.time_offset_s, "Read the truth at stamp + offset, seconds")
      ->capture_default_str()
      ->group(group);
  command.add_option("--report", arguments.page, "Write a report: one HTML file, readable offline")->group(group);
  add_mcap_option(command, arguments.mcap);
  command.add_option("--json", arguments.json, "With -: print metrics.json to stdout")
      ->check(CLI::IsMember({"-"}))
      ->group(group);
  add_progress_option(command, arguments.progress);
  command.add_flag("--quiet", arguments.quiet, "Print errors only")->group(group);
}

}  // namespace

void add_odometry_options(CLI::App& command, OdometryArguments& arguments) {
  command
      .add_option("sequence,--sequence", arguments.sequence,
                  "A folder: TUM (depth.txt), 7-Scenes (frame-000000.depth.png), or numbered .png images; KITTI's, or "
                  "scans as .bin, .pcd or .ply; or a recording: .bag, .mcap, .db3 or a folder of rosbag2")
      ->required();
  add_sequence_options(command, arguments);
  add_method_options(command, arguments.odometry);
  add_lidar_options(command, arguments.lidar);
  add_output_options(command, arguments);
}

}  // namespace augicp::app
