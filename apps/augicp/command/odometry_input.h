// SPDX-License-Identifier: MIT
// Which sequence `augicp odometry` tracks: a folder or a recording, of a depth camera or a LiDAR.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "apps/augicp/command/odometry_arguments.h"
#include "augicp/io/bag_topics.h"
#include "augicp/io/depth_sequence.h"
#include "augicp/io/scan_sequence.h"

namespace augicp::app {

// The topic that is tracked, if the sequence is a recording. Throws IoError if there are none or several.
std::optional<StampedTopic> topic_of(const OdometryArguments& arguments);

bool is_lidar(const OdometryArguments& arguments, const std::optional<StampedTopic>& topic);

// Throw IoError.
ScanSequence scans_of(const OdometryArguments& arguments, const std::optional<StampedTopic>& topic);
DepthSequence images_of(const OdometryArguments& arguments, const std::optional<StampedTopic>& topic);

void print_warnings(const std::vector<std::string>& warnings, bool is_quiet);

}  // namespace augicp::app
