// SPDX-License-Identifier: MIT
#include "augicp/io/read_xyz.h"

#include <algorithm>
#include <optional>

#include "augicp/io/field_text.h"
#include "augicp/io/format.h"
#include "augicp/io/parse_number.h"
#include "augicp/io/text_columns.h"
#include "augicp/io/text_points.h"

namespace augicp {
namespace {

// What the lines before the first point state, and the lines after them.
struct Layout {
  TextPoints points;
  std::optional<std::uint64_t> declared;
  TextLines lines;
  std::vector<std::string> names{};  // of the columns, if the file has some
  std::size_t num_numbers = 0;       // in the line of the first point
};

// The next line that is not a comment; the last comment before it that names positions stands in `comment`.
std::string_view next_content(TextLines& lines, std::string_view* comment = nullptr) {
  while (const auto line = lines.next_not_blank()) {
    if (!is_comment(*line)) return *line;
    if (comment && name_positions(column_names(*line))) *comment = *line;
  }
  return {};
}

// "sep=;", which spreadsheets write in front.
bool is_separator_line(std::string_view line) {
  constexpr std::string_view kMark = "sep=";
  return line.size() <= kMark.size() + 1 && lower_case(line).starts_with(kMark);
}

// A line that states the number of points, as CloudCompare and .pts files have it.
std::optional<std::uint64_t> count_of(std::string_view line) {
  std::string_view rest = line;
  const char separator = separator_of(line);
  if (num_fields(line, separator) != 1) return std::nullopt;
  return parse_count(*next_field(rest, separator));
}

bool begins_with_a_number(std::string_view line) {
  std::string_view rest = line;
  const char separator = separator_of(line);
  const std::string_view field = next_field(rest, separator).value_or("");
  return (separator == ';' ? parse_with_comma(field) : parse_double(field)).has_value();
}

// Without names a point begins with x y z.
PointColumns columns_of(const FileBytes& file, const std::vector<std::string>& names, bool has_header) {
  if (has_header || !names.empty()) return find_columns(file.path, names);
  PointColumns columns;
  for (std::size_t axis = 0; axis < 3; ++axis) columns.of_role[axis] = axis;
  return columns;
}

Layout layout_of(const FileBytes& file) {
  Layout layout{{}, std::nullopt, TextLines(without_bom(file.bytes))};
  layout.points.has_comments = true;
  layout.points.may_have_decimal_commas = true;
  TextLines lines = layout.lines;
  std::string_view comment, line = next_content(lines, &comment);
  if (is_separator_line(line)) {
    layout.lines = lines;
    line = next_content(lines, &comment);
  }
  const auto take_line = [&] {
    layout.lines = lines;
    line = next_content(lines);
  };
  const bool has_header = !line.empty() && !begins_with_a_number(line);
  if (has_header) {
    layout.names = column_names(line);
    take_line();
  }
  layout.declared = count_of(line);
  if (layout.declared) {
    layout.points.num_points = *layout.declared;
    take_line();
  }
  layout.points.separator = separator_of(line);
  layout.num_numbers = num_fields(line, layout.points.separator);
  if (!has_header) layout.names = names_in_comment(file.path, comment, layout.num_numbers);
  if (layout.names.empty()) layout.names = usual_names(file.path, layout.num_numbers, layout.declared.has_value());
  layout.points.columns = columns_of(file, layout.names, has_header);
  return layout;
}

// The columns beside the cloud's own, by number where they have no name.
void add_fields(Layout& layout, PointTable& table) {
  layout.points.has_types = false;
  for (std::size_t column = 0; column < layout.num_numbers; ++column) {
    if (!layout.points.columns.is_field(column)) continue;
    const std::string name = column < layout.names.size() ? layout.names[column] : fmt::format("column_{}", column + 1);
    table.fields.push_back({name, ScalarType::Int64, 1, {}});
    layout.points.fields.push_back(column);
  }
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
  Layout layout = layout_of(file);
  const std::uint64_t most = most_points(file.bytes);
  if (layout.declared) {
    check_num_points(file.path, *layout.declared, options);
    if (*layout.declared > most)
      throw io_error(file.path, fmt::format("expected {} points, the file is too short for them", *layout.declared));
  } else if (most > options.max_points) {
    throw io_error(file.path, fmt::format("expected at most {} points, found {} lines", options.max_points, most));
  }
  PointTable table{"xyz text",   layout.declared.value_or(most),         layout.points.columns.has_normals(), 0,
                   std::nullopt, layout.points.columns.has_intensities()};
  if (options.keep_fields) add_fields(layout, table);
  TextLines behind = layout.lines;
  TextNotes notes;
  CloudFile read = build_cloud(file, table, [&](CloudBuilder& builder) {
    behind = layout.lines;
    notes = add_points(file, layout.points, behind, 0, builder);
  });
  if (notes.has_decimal_commas) read.report.warnings.push_back("commas in numbers were read as decimal points");
  if (!notes.uneven.empty()) read.report.warnings.push_back(notes.uneven);
  if (read.report.num_not_finite > 0)
    read.report.warnings.push_back(fmt::format("{} points read, {} left out: without a finite position within 1e18 m",
                                               read.report.num_declared, read.report.num_not_finite));
  for (PointField& field : read.fields.fields) field = narrowed(std::move(field));
  if (!next_content(behind).empty()) read.report.warnings.push_back("lines after the declared points were not read");
  if (!ends_with_a_line_end(file.bytes)) read.report.warnings.push_back(kNoLineEndWarning);
  return read;
}

}  // namespace augicp
