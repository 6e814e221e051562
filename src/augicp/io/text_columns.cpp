// SPDX-License-Identifier: MIT
#include "augicp/io/text_columns.h"

#include <algorithm>
#include <array>

#include "augicp/io/cloud_builder.h"
#include "augicp/io/format.h"
#include "augicp/io/text_lines.h"

namespace augicp {
namespace {

constexpr std::array<std::string_view, 3> kCoordinateNames{"x", "y", "z"};
constexpr std::array<std::string_view, 3> kShortColours{"r", "g", "b"};
constexpr std::array<const char*, 3> kColours{"red", "green", "blue"};

// The name without the quotes that spreadsheets put around it.
std::string unquoted(std::string_view name) {
  const bool is_quoted = name.size() >= 2 && name.front() == '"' && name.back() == '"';
  return std::string(is_quoted ? name.substr(1, name.size() - 2) : name);
}

// Whether each of the letters is a name once, in either case.
bool has_all(std::span<const std::string> names, const std::array<std::string_view, 3>& letters) {
  return std::all_of(letters.begin(), letters.end(), [&](std::string_view letter) {
    return std::count_if(names.begin(), names.end(),
                         [&](const std::string& name) { return lower_case(name) == letter; }) == 1;
  });
}

void name_colours(std::vector<std::string>& names) {
  if (!has_all(names, kShortColours)) return;
  for (std::size_t k = 0; k < kColours.size(); ++k)
    for (std::string& name : names)
      if (lower_case(name) == kShortColours[k]) name = kColours[k];
}

}  // namespace

std::vector<std::string> column_names(std::string_view line) {
  line = trimmed(line);
  for (const std::string_view mark : {"//", "#", "%"}) {
    if (!line.starts_with(mark)) continue;
    line.remove_prefix(mark.size());
    break;
  }
  std::vector<std::string> names;
  const char separator = separator_of(line);
  while (const auto name = next_field(line, separator)) names.push_back(unquoted(*name));
  name_colours(names);
  return names;
}

bool name_positions(std::span<const std::string> names) { return has_all(names, kCoordinateNames); }

std::vector<std::string> names_in_comment(const std::filesystem::path& path, std::string_view comment,
                                          std::size_t num_numbers) {
  std::vector<std::string> names = column_names(comment);
  if (!name_positions(names)) return {};
  if (names.size() == num_numbers) return names;
  const PointColumns named = find_columns(path, names);
  for (std::size_t axis = 0; axis < 3; ++axis)
    if (named.of_role[axis] != axis)
      throw io_error(path, fmt::format("the comment {} names {} columns, the first point has {} numbers",
                                       in_quotes(comment), names.size(), num_numbers));
  return {};
}

std::vector<std::string> usual_names(const std::filesystem::path& path, std::size_t num_numbers, bool has_count) {
  const std::string extension = lower_case_extension(path);
  const bool is_pts = extension == ".pts" && has_count;
  std::vector<std::string> names{"x", "y", "z"};
  if (is_pts && (num_numbers == 4 || num_numbers == 7)) names.emplace_back("intensity");
  if (num_numbers == names.size() + 3 && (is_pts || extension == ".xyzrgb"))
    names.insert(names.end(), kColours.begin(), kColours.end());
  if (num_numbers == 6 && extension == ".xyzn") names.insert(names.end(), {"nx", "ny", "nz"});
  return names.size() == num_numbers && num_numbers > 3 ? names : std::vector<std::string>{};
}

}  // namespace augicp
