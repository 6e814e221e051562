// SPDX-License-Identifier: MIT
#include "augicp/io/read_xyz.h"

#include <algorithm>
#include <optional>

#include "augicp/io/format.h"
#include "augicp/io/parse_number.h"
#include "augicp/io/text_points.h"

namespace augicp {
namespace {

// The content of the first line, and the lines after it.
struct Layout {
  TextPoints points;
  std::optional<std::uint64_t> declared;
  TextLines lines;
};

std::vector<std::string> column_names(std::string_view line) {
  line = trimmed(line);
  if (line.starts_with("//")) line.remove_prefix(2);  // CloudCompare's comment mark
  std::vector<std::string> names;
  const char separator = separator_of(line);
  while (const auto name = next_field(line, separator)) names.emplace_back(*name);
  return names;
}

std::string_view next_content(TextLines& lines) {
  while (const auto line = lines.next_not_blank())
    if (!trimmed(*line).starts_with('#')) return *line;
  return {};
}

Layout layout_of(const FileBytes& file) {
  Layout layout{{}, std::nullopt, TextLines(without_bom(file.bytes))};
  layout.points.has_comments = true;
  layout.points.columns.of_role[0] = 0;
  layout.points.columns.of_role[1] = 1;
  layout.points.columns.of_role[2] = 2;
  TextLines lines = layout.lines;
  std::string_view line = next_content(lines);
  std::string_view rest = line;
  const std::string_view first = next_field(rest, separator_of(line)).value_or("");
  const bool is_header = !line.empty() && !parse_double(first);
  layout.declared = num_fields(line, separator_of(line)) == 1 ? parse_count(first) : std::nullopt;
  if (is_header) layout.points.columns = find_columns(file.path, column_names(line));
  if (layout.declared) layout.points.num_points = *layout.declared;
  if (is_header || layout.declared) {
    layout.lines = lines;
    line = next_content(lines);
  }
  layout.points.separator = separator_of(line);
  return layout;
}

// The shortest line of a point is "0 0 0" and a line end.
std::uint64_t most_points(std::string_view text) {
  constexpr std::size_t kShortest = 6;
  const auto num_ends = std::count_if(text.begin(), text.end(), [](char c) { return c == '\n' || c == '\r'; });
  return std::min<std::uint64_t>((text.size() + 1) / kShortest, static_cast<std::uint64_t>(num_ends) + 1);
}

}  // namespace

CloudFile parse_xyz(const FileBytes& file, const ReadOptions& options) {
  check_is_text(file);
  const Layout layout = layout_of(file);
  const std::uint64_t most = most_points(file.bytes);
  if (layout.declared) {
    check_num_points(file.path, *layout.declared, options);
    if (*layout.declared > most)
      throw io_error(file.path, fmt::format("expected {} points, the file is too short for them", *layout.declared));
  } else if (most > options.max_points) {
    throw io_error(file.path, fmt::format("expected at most {} points, found {} lines", options.max_points, most));
  }
  const PointTable table{"xyz text",   layout.declared.value_or(most),         layout.points.columns.has_normals(), 0,
                         std::nullopt, layout.points.columns.has_intensities()};
  TextLines behind = layout.lines;
  CloudFile read = build_cloud(file, table, [&](CloudBuilder& builder) {
    behind = layout.lines;
    add_points(file, layout.points, behind, 0, builder);
  });
  if (!next_content(behind).empty()) read.report.warnings.push_back("lines after the declared points were not read");
  if (!ends_with_a_line_end(file.bytes)) read.report.warnings.push_back(kNoLineEndWarning);
  return read;
}

}  // namespace augicp
