// SPDX-License-Identifier: MIT
#include "augicp/io/pose_table.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <utility>

#include "augicp/io/format.h"
#include "augicp/io/parse_number.h"
#include "augicp/io/text_lines.h"
#include "augicp/io/text_points.h"
#include "augicp/io/trajectory_builder.h"

namespace augicp {
namespace {

// The fault of a line, for the message that names the line.
using Fault = std::invalid_argument;

constexpr const char* kPose = "a stamp, a position and a quaternion";

struct Row {
  PoseNumbers numbers;
  std::uint64_t line = 0;
};

// number_at(column) is the number in a column.
template <typename NumberAt>
PoseNumbers picked(const PoseColumns& columns, const NumberAt& number_at) {
  PoseNumbers numbers{};
  for (std::size_t i = 0; i < numbers.size(); ++i) numbers[i] = number_at(columns.of_value[i]);
  if (columns.nanoseconds) numbers[0] += 1e-9 * number_at(*columns.nanoseconds);
  return numbers;
}

TrajectoryFile trajectory_of(const FileBytes& file, const std::vector<Row>& rows, double stamps_per_s) {
  if (rows.empty()) throw io_error(file.path, "expected poses, found none");
  double largest = 0.0;
  for (const Row& row : rows) largest = std::max(largest, std::abs(row.numbers[0]));
  const bool is_stated = stamps_per_s > 0.0;
  const double unit = is_stated ? stamps_per_s : stamps_per_s_by_magnitude(largest);
  TrajectoryBuilder builder;
  for (const Row& row : rows) try {
      builder.add(pose_of_table(row.numbers, unit), row.line);
    } catch (const Fault& fault) {
      throw io_error_at_line(file.path, row.line, fault.what());
    }
  TrajectoryFile read = builder.finished();
  if (!is_stated && unit != 1.0) read.warnings.push_back(unit_sentence(unit));
  if (!ends_with_a_line_end(file.bytes)) read.warnings.push_back(kNoLineEndWarning);
  return read;
}

std::string_view unquoted(std::string_view text) {
  const bool is_quoted = text.size() >= 2 && text.front() == '"' && text.back() == '"';
  return is_quoted ? text.substr(1, text.size() - 2) : text;
}

std::vector<std::string> fields_of_line(std::string_view line) {
  std::vector<std::string> fields;
  const char separator = separator_of(line);
  while (const auto field = next_field(line, separator)) fields.emplace_back(unquoted(*field));
  return fields;
}

double finite_number(std::string_view text) {
  const auto number = parse_double(text);
  if (!number) throw Fault("expected a number, found " + in_quotes(text));
  if (!std::isfinite(*number)) throw Fault("expected a finite number, found " + in_quotes(text));
  return *number;
}

PoseNumbers numbers_of(std::string_view line, const PoseColumns& columns, std::size_t num_columns) {
  const std::vector<std::string> fields = fields_of_line(line);
  if (fields.size() != num_columns)
    throw Fault(fmt::format("expected {} values as in the header, found {}", num_columns, fields.size()));
  return picked(columns, [&](std::size_t column) { return finite_number(fields[column]); });
}

// ---- JSON

using Members = std::vector<std::pair<std::string, double>>;

// The names of the numbers of a list, in its order; empty if they are unknown.
std::string_view letters_of(const std::string& name, std::size_t count) {
  if (count == 3) return "xyz";
  if (count != 4) return "";
  return name.ends_with("xyzw") ? "xyzw" : name.ends_with("wxyz") ? "wxyz" : "";
}

void flatten(const nlohmann::json& value, const std::string& name, int depth, Members& members) {
  constexpr int kDeepest = 8;
  if (depth > kDeepest) throw Fault("expected objects less deep than 8");
  if (value.is_number()) {
    members.emplace_back(name, value.get<double>());
  } else if (value.is_object()) {
    for (const auto& [key, member] : value.items())
      flatten(member, name.empty() ? key : name + '.' + key, depth + 1, members);
  } else if (value.is_array()) {
    const std::string_view letters = letters_of(name, value.size());
    const std::string prefix = letters.size() == 4 ? name.substr(0, name.size() - 4) : name;
    for (std::size_t i = 0; i < letters.size(); ++i) flatten(value[i], prefix + '.' + letters[i], depth + 1, members);
  }
}

Members members_of(std::string_view line) {
  const nlohmann::json object = nlohmann::json::parse(line, nullptr, /*allow_exceptions=*/false);
  const bool has_zero = line.find('\0') != std::string_view::npos;  // the parser would take it for the end
  if (has_zero || !object.is_object()) throw Fault("expected a JSON object, found " + in_quotes(line));
  Members members;
  flatten(object, "", 0, members);
  return members;
}

PoseColumns columns_in(const Members& members) {
  std::vector<std::string> names;
  for (const auto& [name, number] : members) names.push_back(name);
  const auto columns = find_pose_columns(names);
  if (!columns) throw Fault(fmt::format("expected {} by name, found: {}", kPose, fmt::join(names, " ")));
  return *columns;
}

}  // namespace

PoseHeader pose_header(const FileBytes& file) {
  TextLines lines(without_bom(file.bytes));
  PoseHeader found;
  while (const auto line = lines.next_not_blank()) {
    std::string_view content = trimmed(*line);
    const bool is_remark = is_comment(content);
    if (is_remark) content.remove_prefix(content.starts_with('/') ? 2 : 1);
    std::vector<std::string> names = fields_of_line(content);
    if (!is_remark && (names.empty() || parse_double(names.front()))) return found;
    const bool names_a_pose = find_pose_columns(names).has_value();
    if (names_a_pose) found = {std::move(names), is_remark};
    if (!is_remark) return found;
  }
  return found;
}

TrajectoryFile parse_pose_table(const FileBytes& file, const std::vector<std::string>& names) {
  const PoseColumns columns = find_pose_columns(names).value();
  std::vector<Row> rows;
  bool is_first = true;
  TextLines lines(without_bom(file.bytes));
  while (const auto line = lines.next_not_blank()) {
    const std::string_view content = trimmed(*line);
    if (is_comment(content)) continue;
    if (std::exchange(is_first, false) && fields_of_line(content) == names) continue;  // the header
    try {
      rows.push_back({numbers_of(content, columns, names.size()), lines.line()});
    } catch (const Fault& fault) {
      throw io_error_at_line(file.path, lines.line(), fault.what());
    }
  }
  return trajectory_of(file, rows, columns.stamps_per_s);
}

TrajectoryFile parse_pose_objects(const FileBytes& file) {
  std::vector<Row> rows;
  double stamps_per_s = 0.0;
  TextLines lines(without_bom(file.bytes));
  while (const auto line = lines.next_not_blank()) try {
      const Members members = members_of(*line);
      const PoseColumns columns = columns_in(members);
      if (!rows.empty() && columns.stamps_per_s != stamps_per_s) throw Fault("expected the names of the first line");
      stamps_per_s = columns.stamps_per_s;
      rows.push_back({picked(columns, [&](std::size_t column) { return members[column].second; }), lines.line()});
    } catch (const Fault& fault) {
      throw io_error_at_line(file.path, lines.line(), fault.what());
    }
  return trajectory_of(file, rows, stamps_per_s);
}

}  // namespace augicp
