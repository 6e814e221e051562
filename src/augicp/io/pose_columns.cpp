// SPDX-License-Identifier: MIT
#include "augicp/io/pose_columns.h"

#include <algorithm>
#include <initializer_list>
#include <string_view>
#include <vector>

#include "augicp/io/point_fields.h"

namespace augicp {
namespace {

using Words = std::vector<std::string>;

// The words of a name: runs of letters and digits, in lower case.
Words words_of(const std::string& name) {
  Words words(1);
  for (const char c : lower_case(name)) {
    const bool is_part = (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9');
    if (is_part) {
      words.back() += c;
    } else if (!words.back().empty()) {
      words.emplace_back();
    }
  }
  if (words.back().empty()) words.pop_back();
  return words;
}

bool has_any(const Words& words, std::initializer_list<std::string_view> wanted) {
  return std::any_of(words.begin(), words.end(), [&](const std::string& word) {
    return std::find(wanted.begin(), wanted.end(), word) != wanted.end();
  });
}

// Units at the end, such as [m], are no part of a name.
Words without_unit(Words words) {
  if (words.size() > 1 && has_any({words.back()}, {"m", "s", "ms", "us", "ns"})) words.pop_back();
  return words;
}

std::optional<std::size_t> axis_of(const Words& words, std::string_view letters) {
  const std::size_t axis = letters.find(words.back().back());
  return axis == std::string_view::npos ? std::nullopt : std::optional(axis);
}

bool is_stamp(const Words& words) {
  return has_any(words, {"timestamp", "timestamps", "time", "stamp", "secs", "sec", "seconds"}) || words == Words{"t"};
}

bool is_part_of_a_second(const Words& words) { return has_any(words, {"nsec", "nsecs", "nanosec", "nanosecs"}); }

bool is_whole_seconds(const Words& words) {
  return !words.empty() && (words.back() == "sec" || words.back() == "secs");
}

// Of stamps in two columns: sets both, and whether there are both.
bool takes_two(std::span<const std::string> names, PoseColumns& columns) {
  std::optional<std::size_t> seconds;
  for (std::size_t column = 0; column < names.size(); ++column) {
    const Words words = words_of(names[column]);
    if (!seconds && is_whole_seconds(words)) seconds = column;
    if (!columns.nanoseconds && is_part_of_a_second(words)) columns.nanoseconds = column;
  }
  if (!seconds || !columns.nanoseconds) return false;
  columns.of_value[0] = *seconds;
  columns.stamps_per_s = 1.0;
  return true;
}

bool is_quaternion(const Words& words) {
  const std::string& last = words.back();
  const bool is_short = words.size() == 1 && last.size() == 2 && last[0] == 'q';
  return is_short ||
         (last.size() == 1 && has_any(words, {"q", "quat", "quaternion", "orientation", "rotation", "rot"})) ||
         (words.size() > 1 && last.size() == 2 && last[0] == 'q');
}

bool is_position(const Words& words) {
  const std::string& last = words.back();
  const bool is_short = last.size() == 2 && (last[0] == 't' || last[0] == 'p') && words.size() == 1;
  const bool is_bare = last.size() == 1 && words.size() == 1;
  return is_short || is_bare ||
         (last.size() == 1 && has_any(words, {"p", "pos", "position", "t", "translation", "location"}));
}

double stamps_per_s(const Words& words) {
  if (has_any(words, {"ns", "nanoseconds"})) return 1e9;
  if (has_any(words, {"us", "microseconds"})) return 1e6;
  if (has_any(words, {"ms", "milliseconds"})) return 1e3;
  return has_any(words, {"s", "sec", "secs", "seconds"}) ? 1.0 : 0.0;
}

}  // namespace

bool PoseColumns::are_tum(std::size_t num_columns) const {
  for (std::size_t i = 0; i < of_value.size(); ++i)
    if (of_value[i] != i) return false;
  return num_columns == of_value.size() && stamps_per_s <= 1.0 && !nanoseconds;
}

std::optional<PoseColumns> find_pose_columns(std::span<const std::string> names) {
  std::array<std::optional<std::size_t>, 8> found;
  PoseColumns columns;
  const bool has_two = takes_two(names, columns);
  if (has_two) found[0] = columns.of_value[0];
  if (columns.nanoseconds && !has_two) return std::nullopt;
  const auto take = [&](std::size_t value, std::size_t column) {
    if (!found[value]) found[value] = column;
  };
  for (std::size_t column = 0; column < names.size(); ++column) {
    const Words all = words_of(names[column]);
    if (all.empty()) continue;
    const Words words = without_unit(all);
    if (is_stamp(words) || is_part_of_a_second(all)) {
      if (!found[0]) columns.stamps_per_s = stamps_per_s(all);
      take(0, column);
    } else if (const auto axis = axis_of(words, "xyzw"); axis && is_quaternion(words)) {
      take(4 + *axis, column);
    } else if (const auto place = axis_of(words, "xyz"); place && is_position(words)) {
      take(1 + *place, column);
    }
  }
  for (std::size_t value = 0; value < found.size(); ++value) {
    if (!found[value]) return std::nullopt;
    columns.of_value[value] = *found[value];
  }
  return columns;
}

}  // namespace augicp
