// SPDX-License-Identifier: MIT
#include "augicp/io/pose_file.h"

#include <cmath>
#include <optional>
#include <stdexcept>
#include <vector>

#include "augicp/io/format.h"
#include "augicp/io/number_list.h"
#include "augicp/io/parse_number.h"
#include "augicp/io/pose_table.h"
#include "augicp/io/text_lines.h"
#include "augicp/io/text_points.h"

namespace augicp {
namespace {

constexpr std::size_t kThreeRows = 12, kFourRows = 16;  // values of a pose
constexpr std::size_t kTumValues = 8;

// Without comments.
std::string_view content_of(std::string_view line) {
  return is_comment(line) ? std::string_view{} : trimmed(line.substr(0, line.find('#')));
}

std::vector<std::string_view> first_values(const FileBytes& file) {
  std::vector<std::string_view> values;
  TextLines lines(without_bom(file.bytes));
  for (auto line = lines.next(); line && values.empty(); line = lines.next()) {
    std::string_view content = content_of(*line);
    const char separator = separator_of(content);
    while (const auto value = next_field(content, separator)) values.push_back(*value);
  }
  return values;
}

// The number of values that are the pose, if that many are in a line: the others are a stamp.
std::size_t num_pose_values(std::size_t num_values) { return num_values >= kFourRows ? kFourRows : kThreeRows; }

StampedPose pose_of(const std::vector<double>& values, std::size_t place) {
  const std::size_t num_pose = num_pose_values(values.size()), num_before = values.size() - num_pose;
  Mat4d matrix = Mat4d::Identity();
  for (std::size_t i = 0; i < num_pose; ++i)
    matrix(static_cast<int>(i / 4), static_cast<int>(i % 4)) = values[num_before + i];
  if (matrix.row(3) != Mat4d::Identity().row(3))
    throw std::invalid_argument("expected the last row 0 0 0 1 of a 4x4 matrix");
  return {num_before == 0 ? static_cast<double>(place) : values[0], rigid3_from_matrix(matrix)};
}

StampedPose pose_in(std::string_view content, std::size_t num_values, const Trajectory& before) {
  const std::size_t count = num_fields(content, separator_of(content));
  if (count != num_values)
    throw std::invalid_argument(
        fmt::format("expected {} values as in the first line, found {}: {}", num_values, count, in_quotes(content)));
  const StampedPose pose = pose_of(parse_number_list("pose", content, num_values), before.size());
  if (!std::isfinite(pose.stamp_s) || std::abs(pose.stamp_s) > kMaxStamp_s)
    throw std::invalid_argument(fmt::format("expected a timestamp in seconds, found {}", pose.stamp_s));
  if (!before.empty() && pose.stamp_s <= before.back().stamp_s)
    throw std::invalid_argument(
        fmt::format("expected timestamps that increase, found {} after {}", pose.stamp_s, before.back().stamp_s));
  return pose;
}

PoseFile parse_rows(const FileBytes& file, std::size_t num_values) {
  PoseFile read;
  read.has_stamps = num_values > num_pose_values(num_values);
  Trajectory& trajectory = read.content.trajectory;
  TextLines lines(without_bom(file.bytes));
  while (const auto line = lines.next()) {
    const std::string_view content = content_of(*line);
    if (content.empty()) continue;
    try {
      trajectory.push_back(pose_in(content, num_values, trajectory));
    } catch (const std::invalid_argument& fault) {
      throw io_error_at_line(file.path, lines.line(), fault.what());
    }
  }
  if (!ends_with_a_line_end(file.bytes)) read.content.warnings.push_back(kNoLineEndWarning);
  return read;
}

const std::vector<std::string> kTumNames{"timestamp", "tx", "ty", "tz", "qx", "qy", "qz", "qw"};

[[noreturn]] void refuse_words(const FileBytes& file, std::string_view word) {
  const bool is_list = word.starts_with('[');
  throw io_error(file.path, fmt::format("expected numbers, or columns with the names {} or alike; found {}{}",
                                        fmt::join(kTumNames, " "), in_quotes(word),
                                        is_list ? "; of JSON one object a line: jq -c '.[]' IN > OUT" : ""));
}

}  // namespace

PoseFile parse_poses(const FileBytes& file) {
  check_is_text(file);
  TextLines lines(without_bom(file.bytes));
  if (trimmed(lines.next_not_blank().value_or("")).starts_with('{')) return {parse_pose_objects(file), true};
  if (const PoseHeader header = pose_header(file); !header.names.empty()) {
    const bool is_tum = header.is_comment && find_pose_columns(header.names)->are_tum(header.names.size());
    if (!is_tum) return {parse_pose_table(file, header.names), true};
  }
  const std::vector<std::string_view> first = first_values(file);
  for (const std::size_t num_pose : {kThreeRows, kFourRows})
    if (first.size() == num_pose || first.size() == num_pose + 1) return parse_rows(file, first.size());
  const auto number = first.empty() ? std::optional(0.0) : parse_double(first.front());
  if (!number) refuse_words(file, first.front());
  if (first.size() == kTumValues && std::abs(*number) > kMaxStamp_s) return {parse_pose_table(file, kTumNames), true};
  return {parse_tum_trajectory(file), true};
}

PoseFile read_poses(const std::filesystem::path& path) {
  constexpr std::uint64_t kMaxBytes = std::uint64_t{1} << 28;  // a day of poses at 10 Hz
  return parse_poses(read_bytes(path, kMaxBytes));
}

void share_stamps(PoseFile& a, PoseFile& b) {
  if (a.has_stamps == b.has_stamps || a.content.trajectory.size() != b.content.trajectory.size()) return;
  const Trajectory& from = (a.has_stamps ? a : b).content.trajectory;
  PoseFile& to = a.has_stamps ? b : a;
  for (std::size_t i = 0; i < from.size(); ++i) to.content.trajectory[i].stamp_s = from[i].stamp_s;
  to.has_stamps = true;
}

}  // namespace augicp
