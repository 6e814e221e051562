// SPDX-License-Identifier: MIT
// Messages of recordings that are named like files: "drive.mcap#12", "drive.mcap#/points#12".
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>

namespace augicp {

struct BagMessageName {
  std::filesystem::path bag;
  std::string topic;       // empty: the only one of its kind
  std::size_t number = 0;  // of the message in its topic, from 0

  std::string text() const;
};

// Empty if the path is not one of a message: "scan#1.ply", "drive.mcap". Throws IoError for a file of a recording with
// something else behind its name.
std::optional<BagMessageName> parse_bag_message_name(const std::filesystem::path& path);

}  // namespace augicp
