// SPDX-License-Identifier: MIT
// Recordings of robots: bags of ROS 1 (.bag), of ROS 2 (.db3, .mcap, or their folder) and MCAP files.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "augicp/io/point_cloud2.h"

namespace augicp {

struct BagMessage {
  std::string_view topic, type;  // the type as "sensor_msgs/PointCloud2"
  MessageForm form = MessageForm::Cdr;
  std::int64_t stamp_ns = 0;  // when it was recorded
  std::string_view data;      // of the message alone, decompressed
};

// Whether the path is one of a recording: by its extension, or a folder with a metadata.yaml and recordings.
bool is_bag(const std::filesystem::path& path);

class MessageSource;

// The messages of a recording, one after the other: in the order of the file (.bag, .mcap) or of the stamps (.db3), the
// files of a folder in the natural order of their names. Memory: one chunk or one message. Thread safety: none.
class BagReader {
 public:
  // Throws IoError if the path is no recording, or its beginning is damaged.
  explicit BagReader(const std::filesystem::path& bag);
  ~BagReader();
  BagReader(BagReader&&) noexcept;
  BagReader& operator=(BagReader&&) noexcept;

  // The next message, or none behind the last. Its views are valid until the next call. Throws IoError for a file that
  // is damaged or cut short, for one that is not indexed (.bag of a recording that did not end), and for what the
  // library was built without: SQLite, or a compression of chunks.
  std::optional<BagMessage> next();

 private:
  std::vector<std::filesystem::path> files_;
  std::size_t next_file_ = 0;
  std::unique_ptr<MessageSource> source_;
  std::string decompressed_;
};

// Shows every message to the visitor until it returns false. Throws as BagReader does; messages before the damage were
// shown.
void visit_messages(const std::filesystem::path& bag, const std::function<bool(const BagMessage&)>& visit);

struct BagTopic {
  std::string name, type;
  std::uint64_t num_messages = 0;
};

// The topics of a recording, by name, with the number of their messages.
std::vector<BagTopic> bag_topics(const std::filesystem::path& bag);

}  // namespace augicp
