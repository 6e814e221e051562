// SPDX-License-Identifier: MIT
#include "apps/augicp/command/topics.h"

#include <fmt/core.h>
#include <fmt/ranges.h>

#include "augicp/core/error.h"

namespace augicp::app {

StampedTopic chosen_topic(const std::string& bag, const std::string& name, const std::vector<std::string>& types) {
  std::vector<StampedTopic> topics = stamped_topics(bag, types);
  std::erase_if(topics, [](const StampedTopic& topic) {
    return topic.type != kPointCloud2 && !is_depth_encoding(topic.encoding);
  });
  if (topics.empty()) throw IoError(fmt::format("{}: has no topic of {}", bag, fmt::join(types, ", ")));
  if (name.empty() && topics.size() == 1) return topics.front();
  std::string known;
  for (const StampedTopic& topic : topics) {
    if (topic.name == name) return topic;
    known += fmt::format("{}{} ({})", known.empty() ? "" : ", ", topic.name, topic.stamps_s.size());
  }
  throw IoError(fmt::format("{}: which --topic? It has {}", bag, known));
}

}  // namespace augicp::app
