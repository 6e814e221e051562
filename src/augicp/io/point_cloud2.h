// SPDX-License-Identifier: MIT
// The message sensor_msgs/PointCloud2 of ROS 1 and ROS 2.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

#include "augicp/io/cloud_file.h"
#include "augicp/io/message_reader.h"

namespace augicp {

struct PointCloud2 {
  CloudFile file;
  std::int64_t stamp_ns = 0;  // of the header
  std::string frame;          // name of the coordinate frame
};

// Reads one message. Columns are found by name, as in files; all fields are kept with ReadOptions::keep_fields. Throws
// IoError that begins with `source` for a message that is damaged, cut short or without finite points.
PointCloud2 parse_point_cloud2(const std::filesystem::path& source, std::string_view message, MessageForm form,
                               const ReadOptions& options);

}  // namespace augicp
