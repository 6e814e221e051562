// SPDX-License-Identifier: MIT
#include "augicp/io/bag_topics.h"

#include <algorithm>
#include <map>
#include <utility>

#include "augicp/io/file_bytes.h"
#include "augicp/io/format.h"

namespace augicp {

namespace {

std::string encoding_of(const BagMessage& message) {
  if (message.type != kImage && message.type != kCompressedImage) return {};
  try {
    return image_encoding({}, message.type, message.data, message.form);
  } catch (const IoError&) {
    return {};
  }
}

// "/depth/camera_info" of "/depth/image".
std::string camera_info_beside(std::string_view topic) {
  const std::size_t at = topic.rfind('/');
  return at == std::string_view::npos ? std::string() : std::string(topic.substr(0, at)) + "/camera_info";
}

}  // namespace

double stamp_s(const BagMessage& message) {
  constexpr double kNanoseconds = 1e9;
  std::int64_t stamp_ns = 0;
  try {
    const std::filesystem::path nowhere;
    stamp_ns = MessageReader(nowhere, message.type, message.data, message.form).take_header().stamp_ns;
  } catch (const IoError&) {  // whoever reads the message reports it
  }
  return static_cast<double>(stamp_ns != 0 ? stamp_ns : message.stamp_ns) / kNanoseconds;
}

std::vector<StampedTopic> stamped_topics(const std::filesystem::path& bag, std::span<const std::string> types) {
  std::map<std::string, StampedTopic, std::less<>> by_name;
  BagReader reader(bag);
  while (const auto message = reader.next()) {
    if (std::find(types.begin(), types.end(), message->type) == types.end()) continue;
    auto entry = by_name.find(message->topic);
    if (entry == by_name.end())
      entry =
          by_name
              .emplace(message->topic,
                       StampedTopic{std::string(message->topic), std::string(message->type), {}, encoding_of(*message)})
              .first;
    entry->second.stamps_s.push_back(stamp_s(*message));
  }
  std::vector<StampedTopic> topics;
  for (auto& [name, topic] : by_name) topics.push_back(std::move(topic));
  return topics;
}

StampedTopic chosen_topic(const std::filesystem::path& bag, const std::string& name,
                          std::span<const std::string> types) {
  std::vector<StampedTopic> topics = stamped_topics(bag, types);
  std::erase_if(topics, [](const StampedTopic& topic) {
    return topic.type != kPointCloud2 && !is_depth_encoding(topic.encoding);
  });
  if (topics.empty()) throw io_error(bag, fmt::format("has no topic of {}", fmt::join(types, ", ")));
  if (name.empty() && topics.size() == 1) return topics.front();
  std::string known;
  for (const StampedTopic& topic : topics) {
    if (topic.name == name) return topic;
    known += fmt::format("{}{} ({})", known.empty() ? "" : ", ", topic.name, topic.stamps_s.size());
  }
  throw io_error(bag, fmt::format("which topic? It has {}", known));
}

CloudFile parse_cloud_message(const std::filesystem::path& source, const BagMessage& message,
                              const ReadOptions& options) {
  if (message.type != kPointCloud2)
    throw io_error(source, fmt::format("is a {}, expected a {}", message.type, kPointCloud2));
  return parse_point_cloud2(source, message.data, message.form, options).file;
}

TopicReader::TopicReader(std::filesystem::path bag, std::string topic)
    : bag_(std::move(bag)), topic_(std::move(topic)) {}

BagMessage TopicReader::message(std::size_t number) {
  if (!reader_ || number < next_) {
    reader_.emplace(bag_);
    next_ = 0;
  }
  while (const auto message = reader_->next())
    if (message->topic == topic_ && next_++ == number) return *message;
  throw io_error(bag_, next_ == 0 ? fmt::format("has no messages of the topic {}", topic_)
                                  : fmt::format("has no message {} of {}: the last of its {} messages is {}", number,
                                                topic_, next_, next_ - 1));
}

std::optional<DepthCamera> camera_of_topic(const std::filesystem::path& bag, const std::string& topic) {
  const bool are_rectified = topic.find("rect") != std::string::npos;
  const std::string beside = camera_info_beside(topic), above = camera_info_beside(topic.substr(0, topic.rfind('/')));
  std::optional<DepthCamera> camera;
  BagReader reader(bag);
  while (const auto message = reader.next()) {
    if (message->type != kCameraInfo || (message->topic != beside && message->topic != above)) continue;
    if (message->topic == above && camera) continue;
    const std::filesystem::path source = bag.string() + ": " + std::string(message->topic);
    camera = parse_camera_info(source, message->data, message->form, are_rectified);
    if (message->topic == beside) break;
  }
  return camera;
}

}  // namespace augicp
