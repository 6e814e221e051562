// SPDX-License-Identifier: MIT
// Topics of a recording whose messages begin with a header: their stamps, and their messages by number.
#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "augicp/io/bag.h"
#include "augicp/io/ros_image.h"

namespace augicp {

inline constexpr const char* kPointCloud2 = "sensor_msgs/PointCloud2";

struct StampedTopic {
  std::string name, type;
  std::vector<double> stamps_s;  // of the messages, in the order of BagReader
  std::string encoding{};        // of images: that of the first one, see image_encoding(); empty if that is damaged
};

// The topics of these types, by name. A stamp is that of the header, or if it is zero that of the recording, seconds.
// Reads the whole recording; throws as BagReader does.
std::vector<StampedTopic> stamped_topics(const std::filesystem::path& bag, std::span<const std::string> types);

// The topic of that name, or if no name is given the only one of these types. Only depth images count as images. Throws
// IoError that lists the topics of these types, with the number of their messages. Reads the whole recording.
StampedTopic chosen_topic(const std::filesystem::path& bag, const std::string& name,
                          std::span<const std::string> types);

// The stamp of a message whose type begins with a header. Never throws: a damaged header leaves the recording's stamp.
double stamp_s(const BagMessage& message);

// The cloud of a message. source: for messages. Throws IoError, also for another type than PointCloud2.
CloudFile parse_cloud_message(const std::filesystem::path& source, const BagMessage& message,
                              const ReadOptions& options);

// The messages of one topic by their number, from 0. Numbers that ascend cost one pass through the recording; a step
// back begins another. Thread safety: none.
class TopicReader {
 public:
  TopicReader(std::filesystem::path bag, std::string topic);

  // Valid until the next call. Throws IoError, also if there are not as many.
  BagMessage message(std::size_t number);

 private:
  std::filesystem::path bag_;
  std::string topic_;
  std::optional<BagReader> reader_;
  std::size_t next_ = 0;
};

// The camera of a topic of images: by the first camera_info beside it, or one level above
// ("depth/image/compressedDepth"). Images of topics whose name has "rect" are rectified. Empty if there is none. Throws
// IoError.
std::optional<DepthCamera> camera_of_topic(const std::filesystem::path& bag, const std::string& topic);

}  // namespace augicp
