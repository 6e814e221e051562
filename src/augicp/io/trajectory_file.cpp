// SPDX-License-Identifier: MIT
#include "augicp/io/trajectory_file.h"

#include <array>
#include <charconv>
#include <cmath>
#include <optional>
#include <span>
#include <stdexcept>

#include "augicp/core/check.h"
#include "augicp/io/atomic_file.h"
#include "augicp/io/format.h"
#include "augicp/io/parse_number.h"
#include "augicp/io/pose_numbers.h"
#include "augicp/io/text_lines.h"
#include "augicp/io/text_points.h"
#include "augicp/io/trajectory_builder.h"

namespace augicp {
namespace {

constexpr const char* kPoseColumns = "timestamp tx ty tz qx qy qz qw";
constexpr std::size_t kNumColumns = 8;

// The fault of a line, for the message that names the line.
using Fault = std::invalid_argument;

PoseNumbers line_numbers(std::string_view content) {
  const char separator = separator_of(content);
  const std::size_t count = num_fields(content, separator);
  if (count != kNumColumns)
    throw Fault(
        fmt::format("expected {} values, {}, found {}: {}", kNumColumns, kPoseColumns, count, in_quotes(content)));
  PoseNumbers numbers{};
  for (double& number : numbers) {
    const std::string_view field = *next_field(content, separator);
    const std::optional<double> value = parse_double(field);
    if (!value) throw Fault("expected a number, found " + in_quotes(field));
    if (!std::isfinite(*value)) throw Fault("expected a finite number, found " + in_quotes(field));
    number = *value;
  }
  return numbers;
}

// The shortest text in fixed notation that reads back as the same number, with at least 6 decimals.
std::string stamp_text(double stamp_s) {
  std::array<char, 512> buffer{};  // the smallest number has 323 zeros after the point
  const auto end = std::to_chars(buffer.begin(), buffer.end(), stamp_s, std::chars_format::fixed).ptr;
  std::string text(buffer.begin(), end);
  constexpr std::size_t kNumDecimals = 6;
  if (text.find('.') == std::string::npos) text += '.';
  const std::size_t num_decimals = text.size() - text.find('.') - 1;
  if (num_decimals < kNumDecimals) text.append(kNumDecimals - num_decimals, '0');
  return text;
}

}  // namespace

TrajectoryFile parse_tum_trajectory(const FileBytes& file) {
  check_is_text(file);
  TrajectoryBuilder builder;
  TextLines lines(without_bom(file.bytes));
  while (const auto line = lines.next()) {
    const std::string_view content = trimmed(line->substr(0, line->find('#')));
    if (content.empty() || is_comment(content)) continue;
    try {
      builder.add(pose_of_table(line_numbers(content), 1.0), lines.line());
    } catch (const Fault& fault) {
      throw io_error_at_line(file.path, lines.line(), fault.what());
    }
  }
  TrajectoryFile read = builder.finished();
  if (read.trajectory.empty())
    throw io_error(file.path, fmt::format("expected poses, {} a line, found none", kPoseColumns));
  if (!ends_with_a_line_end(file.bytes)) read.warnings.push_back(kNoLineEndWarning);
  return read;
}

TrajectoryFile read_tum_trajectory(const std::filesystem::path& path) {
  constexpr std::uint64_t kMaxBytes = std::uint64_t{1} << 28;  // a day of poses at 40 Hz
  return parse_tum_trajectory(read_bytes(path, kMaxBytes));
}

void write_tum_trajectory(const std::filesystem::path& path, const Trajectory& trajectory) {
  check_order(trajectory);
  std::string text =
      fmt::format("# T_world_camera: the pose of the camera in the world, seconds, metres\n# {}\n", kPoseColumns);
  for (const auto& [stamp_s, world_from_camera] : trajectory) {
    require(std::abs(stamp_s) <= kMaxStamp_s, "stamp_s", stamp_s, "must be seconds, at most 1e11");
    const Vec3d& t = world_from_camera.translation;
    const Eigen::Quaterniond& q = world_from_camera.rotation;
    const PoseNumbers numbers{stamp_s, t.x(), t.y(), t.z(), q.x(), q.y(), q.z(), q.w()};
    pose_of_numbers("trajectory", std::span(numbers).subspan<1>());  // throws for poses that the reader would refuse
    text += fmt::format("{} {}\n", stamp_text(stamp_s), fmt::join(std::span(numbers).subspan<1>(), " "));
  }
  write_file(path, text);
}

}  // namespace augicp
