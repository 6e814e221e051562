// SPDX-License-Identifier: MIT
#include "augicp/io/sequence_folders.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <map>

#include "augicp/io/format.h"
#include "augicp/io/parse_number.h"
#include "augicp/io/text_lines.h"

namespace augicp {
namespace {

// The number at the end of a name, if there is one that a stamp can be made of.
std::optional<std::uint64_t> number_at_end(std::string_view name) {
  constexpr std::size_t kMaxDigits = 15;  // exact in a double
  std::size_t begin = name.size();
  while (begin > 0 && name.size() - begin < kMaxDigits && name[begin - 1] >= '0' && name[begin - 1] <= '9') --begin;
  return parse_count(name.substr(begin));
}

}  // namespace

std::vector<DepthFrameFile> parse_image_list(const FileBytes& list) {
  std::vector<DepthFrameFile> frames;
  TextLines lines(without_bom(list.bytes));
  while (const auto line = lines.next_not_blank()) {
    std::string_view rest = trimmed(*line);
    if (rest.front() == '#') continue;
    const auto stamp = next_field(rest), path = next_field(rest);
    const auto stamp_s = stamp ? parse_double(*stamp) : std::nullopt;
    if (!stamp_s || !std::isfinite(*stamp_s))
      throw io_error_at_line(list.path, lines.line(), "expected a time stamp in seconds, found " + in_quotes(*stamp));
    if (!path || next_field(rest))
      throw io_error_at_line(list.path, lines.line(), "expected a time stamp and a path, found " + in_quotes(*line));
    frames.push_back({*stamp_s, list.path.parent_path() / *path});
  }
  return frames;
}

std::vector<DepthFrameFile> numbered_files(const std::filesystem::path& folder, std::string_view ending,
                                           double frames_per_s) {
  std::map<std::uint64_t, std::filesystem::path> by_number;
  std::error_code error;
  for (const auto& entry : std::filesystem::directory_iterator(folder, error)) {
    const std::string name = entry.path().filename().string();
    if (!name.ends_with(ending)) continue;
    const auto number = number_at_end(std::string_view(name).substr(0, name.size() - ending.size()));
    if (!number) continue;
    const auto [other, is_new] = by_number.emplace(*number, entry.path());
    if (!is_new)
      throw io_error(folder, fmt::format("expected one image a number, found {} and {}",
                                         other->second.filename().string(), name));
  }
  if (error) throw io_error(folder, "cannot be listed: " + error.message());
  std::vector<DepthFrameFile> frames;
  for (const auto& [number, path] : by_number) frames.push_back({static_cast<double>(number) / frames_per_s, path});
  return frames;
}

}  // namespace augicp
