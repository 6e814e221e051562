// SPDX-License-Identifier: MIT
#include "augicp/io/sequence_folders.h"

#include <cmath>
#include <map>

#include "augicp/io/format.h"
#include "augicp/io/parse_number.h"
#include "augicp/io/stamp_unit.h"
#include "augicp/io/text_lines.h"
#include "augicp/io/trajectory_file.h"

namespace augicp {
namespace {

constexpr const char* kImageEndings[] = {".png", ".pgm", ".npy", ".pfm", ".tif", ".tiff"};

// The number at the end of a name without its extension: digits, with or without a decimal point.
std::string_view number_at_end(std::string_view name) {
  const std::size_t before = name.find_last_not_of("0123456789.");
  name.remove_prefix(before == std::string_view::npos ? 0 : before + 1);
  const std::size_t first_digit = name.find_first_not_of('.');
  return first_digit == std::string_view::npos ? std::string_view{} : name.substr(first_digit);
}

// Empty if the name does not end in a number.
std::optional<double> stamp_of(const std::filesystem::path& file, std::string_view stem, double frames_per_s) {
  const std::string_view number = number_at_end(stem);
  const auto value = parse_double(number);
  if (number.empty() || !value) return std::nullopt;
  const bool is_stamp = number.find('.') != std::string_view::npos;
  if (!(*value <= (is_stamp ? kMaxStamp_s : kMaxFrameNumber)))
    throw io_error(file,
                   "its number is too large for a frame's: where it is a stamp, write a depth.txt with lines \"stamp "
                   "path\" in seconds");
  return is_stamp ? *value : *value / frames_per_s;
}

bool ends_with(std::string name, std::string_view ending) {
  for (char& c : name)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return name.ends_with(ending);
}

std::size_t count_files(const std::filesystem::path& folder, std::string_view ending) {
  std::error_code error;
  std::size_t count = 0;
  for (std::filesystem::directory_iterator entry(folder, error), end; !error && entry != end; entry.increment(error))
    count += ends_with(entry->path().filename().string(), ending);
  return count;
}

}  // namespace

std::vector<DepthFrameFile> parse_image_list(const FileBytes& list) {
  std::vector<DepthFrameFile> frames;
  TextLines lines(without_bom(list.bytes));
  while (const auto line = lines.next_not_blank()) {
    std::string_view rest = trimmed(*line);
    if (rest.front() == '#') continue;
    const auto stamp = next_field(rest);
    const auto stamp_s = stamp ? parse_double(*stamp) : std::nullopt;
    if (!stamp_s || !std::isfinite(*stamp_s))
      throw io_error_at_line(list.path, lines.line(), "expected a time stamp in seconds, found " + in_quotes(*stamp));
    const std::string_view path = trimmed(rest);
    if (path.empty())
      throw io_error_at_line(list.path, lines.line(), "expected a time stamp and a path, found " + in_quotes(*line));
    frames.push_back({*stamp_s, list.path.parent_path() / path});
  }
  return frames;
}

std::vector<DepthFrameFile> numbered_files(const std::filesystem::path& folder, std::string_view ending,
                                           double frames_per_s) {
  std::map<double, std::filesystem::path> by_stamp;
  std::error_code error;
  for (std::filesystem::directory_iterator entry(folder, error), end; !error && entry != end; entry.increment(error)) {
    const std::string name = entry->path().filename().string();
    if (!ends_with(name, ending)) continue;
    const auto stamp_s =
        stamp_of(entry->path(), std::string_view(name).substr(0, name.size() - ending.size()), frames_per_s);
    if (!stamp_s) continue;
    const auto [other, is_new] = by_stamp.emplace(*stamp_s, entry->path());
    if (!is_new)
      throw io_error(
          folder, fmt::format("expected one image a number, found {} and {}", other->second.filename().string(), name));
  }
  if (error) throw io_error(folder, "cannot be listed: " + error.message());
  std::vector<DepthFrameFile> frames;
  for (const auto& [stamp_s, path] : by_stamp) frames.push_back({stamp_s, path});
  return frames;
}

NumberedImages numbered_images(const std::filesystem::path& folder, double frames_per_s) {
  NumberedImages images;
  std::string kind, others;
  for (const char* ending : kImageEndings) {
    const std::size_t num_files = count_files(folder, ending);
    std::size_t num_read = 0;
    if (kind.empty() && num_files > 0) {
      images.frames = numbered_files(folder, ending, frames_per_s);
      num_read = images.frames.size();
      if (num_read > 0) kind = ending;
    }
    if (num_files > num_read)
      others += fmt::format("{}{} {}{}", others.empty() ? "" : ", ", num_files - num_read, ending,
                            kind == ending || kind.empty() ? " without a number at the end of the name" : "");
  }
  if (!others.empty() && !kind.empty())
    images.left_out = fmt::format("{} {} images are read, and left out are {}", images.frames.size(), kind, others);
  return images;
}

}  // namespace augicp
