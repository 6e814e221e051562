// SPDX-License-Identifier: MIT
#include "augicp/io/read_xyz.h"

#include <algorithm>
#include <array>
#include <optional>
#include <span>

#include "augicp/io/field_text.h"
#include "augicp/io/format.h"
#include "augicp/io/parse_number.h"
#include "augicp/io/text_points.h"

namespace augicp {
namespace {

constexpr std::array<std::string_view, 3> kCoordinateNames{"x", "y", "z"};

// What the lines before the first point state, and the lines after them.
struct Layout {
  TextPoints points;
  std::optional<std::uint64_t> declared;
  TextLines lines;
  std::vector<std::string> names{};  // of the columns, if the file has some
  std::size_t num_numbers = 0;       // in the line of the first point
};

// The name without the quotes that spreadsheets put around it.
std::string unquoted(std::string_view name) {
  const bool is_quoted = name.size() >= 2 && name.front() == '"' && name.back() == '"';
  return std::string(is_quoted ? name.substr(1, name.size() - 2) : name);
}

std::vector<std::string> column_names(std::string_view line) {
  line = trimmed(line);
  if (line.starts_with("//")) line.remove_prefix(2);  // CloudCompare's comment mark
  if (line.starts_with('#')) line.remove_prefix(1);
  std::vector<std::string> names;
  const char separator = separator_of(line);
  while (const auto name = next_field(line, separator)) names.push_back(unquoted(*name));
  return names;
}

// Whether the names are x, y and z, each once, beside others.
bool name_positions(std::span<const std::string> names) {
  return std::all_of(kCoordinateNames.begin(), kCoordinateNames.end(), [&](std::string_view coordinate) {
    return std::count_if(names.begin(), names.end(), [&](const std::string& name) {
             return name.size() == 1 && (name[0] | ('a' - 'A')) == coordinate[0];
           }) == 1;
  });
}

// The next line that is not a comment; the last comment before it that names positions stands in `comment`.
std::string_view next_content(TextLines& lines, std::string_view* comment = nullptr) {
  while (const auto line = lines.next_not_blank()) {
    if (!trimmed(*line).starts_with('#')) return *line;
    if (comment && name_positions(column_names(*line))) *comment = *line;
  }
  return {};
}

// The columns that a comment before the first point names, as in "# r g b x y z"; empty where it names no positions, or
// another number of columns than the point has. Throws IoError where that contradicts positions in front.
std::vector<std::string> names_in_comment(const FileBytes& file, std::string_view comment, std::size_t num_numbers) {
  std::vector<std::string> names = column_names(comment);
  if (!name_positions(names)) return {};
  if (names.size() == num_numbers) return names;
  const PointColumns named = find_columns(file.path, names);
  for (std::size_t axis = 0; axis < 3; ++axis)
    if (named.of_role[axis] != axis)
      throw io_error(file.path, fmt::format("the comment {} names {} columns, the first point has {} numbers",
                                            in_quotes(comment), names.size(), num_numbers));
  return {};
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
  if (!has_header) layout.names = names_in_comment(file, comment, layout.num_numbers);
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
  bool has_commas = false;
  CloudFile read = build_cloud(file, table, [&](CloudBuilder& builder) {
    behind = layout.lines;
    has_commas = add_points(file, layout.points, behind, 0, builder);
  });
  if (has_commas) read.report.warnings.push_back("commas in numbers were read as decimal points");
  for (PointField& field : read.fields.fields) field = narrowed(std::move(field));
  if (!next_content(behind).empty()) read.report.warnings.push_back("lines after the declared points were not read");
  if (!ends_with_a_line_end(file.bytes)) read.report.warnings.push_back(kNoLineEndWarning);
  return read;
}

}  // namespace augicp
