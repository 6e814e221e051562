// SPDX-License-Identifier: MIT
#include "augicp/io/pose_file.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <vector>

#include "augicp/io/format.h"
#include "augicp/io/number_list.h"
#include "augicp/io/pose_table.h"
#include "augicp/io/text_lines.h"
#include "augicp/io/text_points.h"

namespace augicp {
namespace {

constexpr std::size_t kNumRows = 12;  // values of the first three rows

std::string_view content_of(std::string_view line) { return trimmed(line.substr(0, line.find('#'))); }

std::size_t num_values_of_first_line(const FileBytes& file) {
  TextLines lines(without_bom(file.bytes));
  while (const auto line = lines.next())
    if (const std::string_view content = content_of(*line); !content.empty())
      return num_fields(content, separator_of(content));
  return 0;
}

StampedPose pose_of(const std::vector<double>& values, std::size_t place) {
  const std::size_t num_before = values.size() - kNumRows;
  Mat4d matrix = Mat4d::Identity();
  for (std::size_t i = 0; i < kNumRows; ++i)
    matrix(static_cast<int>(i / 4), static_cast<int>(i % 4)) = values[num_before + i];
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
  read.has_stamps = num_values > kNumRows;
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

}  // namespace

PoseFile parse_poses(const FileBytes& file) {
  check_is_text(file);
  TextLines lines(without_bom(file.bytes));
  if (trimmed(lines.next_not_blank().value_or("")).starts_with('{')) return {parse_pose_objects(file), true};
  if (const PoseHeader header = pose_header(file); !header.names.empty()) {
    const bool is_tum = header.is_comment && find_pose_columns(header.names)->are_tum(header.names.size());
    if (!is_tum) return {parse_pose_table(file, header.names), true};
  }
  const std::size_t num_values = num_values_of_first_line(file);
  if (num_values == kNumRows || num_values == kNumRows + 1) return parse_rows(file, num_values);
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
