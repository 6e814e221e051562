// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "augicp/io/cloud_builder.h"
#include "augicp/io/text_lines.h"

namespace augicp {

// Points in text, one per line, with optional blank lines and comments.
struct TextPoints {
  PointColumns columns;
  std::size_t num_columns = 0;  // exact number of fields per line; 0: the required ones, or more
  char separator = ' ';
  bool has_comments = false;                                             // see is_comment()
  std::uint64_t num_points = std::numeric_limits<std::uint64_t>::max();  // max: all lines

  std::vector<std::size_t> fields{};     // the first column of each of PointTable::fields; its others follow it
  bool may_have_decimal_commas = false;  // between semicolons
  bool has_types = true;                 // whether the file states the types of its fields; else they begin as Int64
};

// Whether a line is a comment of text files that state no format: it begins with '#', '%' (MATLAB) or '//'.
bool is_comment(std::string_view line);

// What add_points() noticed on the way.
struct TextNotes {
  bool has_decimal_commas = false;
  std::string uneven{};  // a sentence on the first line with more or fewer values than the first point; empty if none
};

// Adds the points of the next num_points lines; lines then stands behind the last of them. lines_before is the number
// of lines of the file before `lines`, for messages. Throws IoError if a line is not a point, or there are too few, or
// if numbers have decimal commas and points: the commas may be thousands separators.
TextNotes add_points(const FileBytes& file, const TextPoints& points, TextLines& lines, std::uint64_t lines_before,
                     CloudBuilder& builder);

// A number, also with a decimal comma.
std::optional<double> parse_with_comma(std::string_view cell);

// Throws IoError if a text file has a zero byte near its front.
void check_is_text(const FileBytes& file);

// For text files that end within a line: nothing else shows that the last number is cut.
inline constexpr const char* kNoLineEndWarning =
    "the last line has no end: if the file was cut short, so may its last number be";

}  // namespace augicp
