// SPDX-License-Identifier: MIT
#include "augicp/io/bag_message_name.h"

#include "augicp/io/bag.h"
#include "augicp/io/file_bytes.h"
#include "augicp/io/format.h"
#include "augicp/io/parse_number.h"

namespace augicp {
namespace {

// "12" or "/points#12".
std::optional<BagMessageName> named(const std::string& bag, std::string_view rest) {
  const std::size_t before_number = rest.rfind('#');
  const bool has_topic = before_number != std::string_view::npos;
  const auto number = parse_count(has_topic ? rest.substr(before_number + 1) : rest);
  if (!number || before_number == 0) return std::nullopt;
  return BagMessageName{bag, std::string(rest.substr(0, has_topic ? before_number : 0)), *number};
}

}  // namespace

std::string BagMessageName::text() const {
  return fmt::format("{}#{}{}{}", bag.string(), topic, topic.empty() ? "" : "#", number);
}

std::optional<BagMessageName> parse_bag_message_name(const std::filesystem::path& path) {
  const std::string text = path.string();
  bool is_in_file = false;
  for (std::size_t at = text.find('#'); at != std::string::npos; at = text.find('#', at + 1)) {
    const std::filesystem::path bag = text.substr(0, at);
    if (!is_bag(bag)) continue;
    if (auto name = named(bag.string(), std::string_view(text).substr(at + 1))) return name;
    is_in_file = is_in_file || bag.has_extension();
  }
  if (is_in_file && !is_bag(path))
    throw io_error(path,
                   "expected the number of a message, as drive.mcap#12, or a topic and a number, as "
                   "drive.mcap#/points#12");
  return std::nullopt;
}

}  // namespace augicp
