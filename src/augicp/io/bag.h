// SPDX-License-Identifier: MIT
// Recordings of robots: bags of ROS 1 (.bag), of ROS 2 (.db3, .mcap, or their folder) and MCAP files.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "augicp/io/point_cloud2.h"

namespace augicp {

struct BagMessage {
  std::string_view topic, type;  // the type as "sensor_msgs/PointCloud2"
  MessageForm form = MessageForm::Cdr;
  std::int64_t stamp_ns = 0;  // when it was recorded
  std::string_view data;      // until the visitor returns
};

// Whether the path is one of a recording: by its extension, or a folder with a metadata.yaml and recordings.
bool is_bag(const std::filesystem::path& path);

// Shows every message to the visitor, in the order of the file (.bag, .mcap) or of the stamps (.db3), until it returns
// false. Memory: one chunk or one message. Throws IoError for a file that is damaged or cut short, for one that is not
// indexed (.bag of a recording that did not end), for compressed chunks, and for .db3 if the library was built without
// SQLite; messages before the damage were shown.
void visit_messages(const std::filesystem::path& bag, const std::function<bool(const BagMessage&)>& visit);

struct BagTopic {
  std::string name, type;
  std::uint64_t num_messages = 0;
};

// The topics of a recording, by name, with the number of their messages.
std::vector<BagTopic> bag_topics(const std::filesystem::path& bag);

}  // namespace augicp
