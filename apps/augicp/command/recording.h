// SPDX-License-Identifier: MIT
// Results as MCAP (--mcap), for Foxglove, rerun and ros2 bag play.
#pragma once

#include <CLI/CLI.hpp>
#include <filesystem>
#include <functional>
#include <string>

#include "apps/augicp/text/align.h"
#include "apps/augicp/text/odometry.h"
#include "augicp/io/cloud_file.h"
#include "augicp/io/depth_sequence.h"

namespace augicp::app {

void add_mcap_option(CLI::App& command, std::string& path);

// Of each frame with a pose: /tf and /odometry (map from sensor), and /points in the frame of the sensor, as cloud_of
// gives them; frames that it throws IoError for have none. /map, unless it is empty. Throws IoError.
void write_odometry_mcap(const std::filesystem::path& path, const OdometryRun& run, const Cloud& map,
                         const std::function<CloudFile(const FrameRow&)>& cloud_of);

// The same for depth images, as points of a grid of at least 160 columns.
void write_depth_mcap(const std::filesystem::path& path, const OdometryRun& run, const DepthSequence& sequence,
                      const DepthCamera& camera, double depth_scale);

// /target; /source in the frame of the target; /tf and /odometry (target from source). moved: the source, moved. All
// stamps are 0. Throws IoError.
void write_align_mcap(const std::filesystem::path& path, const AlignReport& report, const CloudFile& moved,
                      const CloudFile& target);

}  // namespace augicp::app
