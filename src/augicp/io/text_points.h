// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include "augicp/io/cloud_builder.h"
#include "augicp/io/text_lines.h"

namespace augicp {

// Points in text, one a line, blank lines and comments between them.
struct TextPoints {
  PointColumns columns;
  std::size_t num_columns = 0;  // a line must have exactly as many; 0: as many as are needed, or more
  char separator = ' ';
  bool has_comments = false;                                             // lines that start with '#'
  std::uint64_t num_points = std::numeric_limits<std::uint64_t>::max();  // max: all there are
};

// Adds the points of the next num_points lines and leaves lines behind the last of them. lines_before is the number
// of lines of the file that are not in lines, for messages. Throws IoError where a line is not a point, or too few are
// there.
void add_points(const FileBytes& file, const TextPoints& points, TextLines& lines, std::uint64_t lines_before,
                CloudBuilder& builder);

// A file of text must not hold a zero byte near its front. Throws IoError.
void check_is_text(const FileBytes& file);

// For files of text that end within a line: where the last number is cut short, nothing else shows it.
inline constexpr const char* kNoLineEndWarning =
    "the last line has no end: if the file was cut short, so may its last number be";

}  // namespace augicp
