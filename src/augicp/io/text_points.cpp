// SPDX-License-Identifier: MIT
#include "augicp/io/text_points.h"

#include <algorithm>

#include "augicp/io/field_text.h"
#include "augicp/io/format.h"
#include "augicp/io/parse_number.h"

namespace augicp {
namespace {

constexpr std::size_t kNoRole = kNumRoles;

std::vector<std::size_t> roles_of(const PointColumns& columns) {
  std::vector<std::size_t> roles;
  for (std::size_t role = 0; role < kNumRoles; ++role) {
    const std::size_t column = columns.of_role[role];
    if (column == kNoColumn) continue;
    roles.resize(std::max(roles.size(), column + 1), kNoRole);
    roles[column] = role;
  }
  return roles;
}

class LineParser {
 public:
  LineParser(const FileBytes& file, const TextPoints& points)
      : file_(file), points_(points), roles_(roles_of(points.columns)) {
    values_[6] = static_cast<double>(Structure::Planar);  // a normal without a structure belongs to a plane
  }

  // Adds the point of the line, and its fields.
  void add(std::string_view line, std::uint64_t number, CloudBuilder& builder) {
    if (!builder.add(parse(line, number)) || points_.fields.empty()) return;
    cells_.clear();
    std::string_view rest = line;
    while (const auto cell = next_field(rest, points_.separator)) cells_.push_back(*cell);
    for (std::size_t i = 0; i < points_.fields.size(); ++i) add_field(i, number, builder);
  }

 private:
  void add_field(std::size_t index, std::uint64_t number, CloudBuilder& builder) const {
    if (builder.is_dropped(index)) return;
    PointField& field = builder.fields()[index];
    for (std::size_t k = 0; k < field.count; ++k) {
      const std::size_t column = points_.fields[index] + k;
      const std::string_view cell = column < cells_.size() ? cells_[column] : "";
      if (points_.has_types ? append_number(field, cell) : append_untyped_number(field, cell)) continue;
      return builder.drop_field(
          index, fmt::format("column {} has {} in line {}, no number", in_quotes(field.name), in_quotes(cell), number));
    }
  }

  const PointValues& parse(std::string_view line, std::uint64_t number) {
    std::size_t column = 0;
    std::string_view rest = line;
    for (; column < roles_.size(); ++column) {
      const auto field = next_field(rest, points_.separator);
      if (!field) break;
      if (roles_[column] == kNoRole) continue;
      const auto value = parse_double(*field);
      if (!value) throw io_error_at_line(file_.path, number, "expected a number, found " + in_quotes(*field));
      values_[roles_[column]] = *value;
    }
    column += num_fields(rest, points_.separator);
    const bool exact = points_.num_columns > 0;
    const std::size_t expected = exact ? points_.num_columns : roles_.size();
    if (column < expected || (exact && column > expected))
      throw io_error_at_line(file_.path, number,
                             fmt::format("expected {}{} values, found {}: {}", exact ? "" : "at least ", expected,
                                         column, in_quotes(line)));
    return values_;
  }

  const FileBytes& file_;
  const TextPoints& points_;
  std::vector<std::size_t> roles_;  // by column
  PointValues values_{};
  std::vector<std::string_view> cells_;
};

}  // namespace

void add_points(const FileBytes& file, const TextPoints& points, TextLines& lines, std::uint64_t lines_before,
                CloudBuilder& builder) {
  const bool all = points.num_points == std::numeric_limits<std::uint64_t>::max();
  LineParser parser(file, points);
  for (std::uint64_t i = 0; i < points.num_points;) {
    const auto line = lines.next_not_blank();
    if (!line && all) return;
    if (!line) throw io_error(file.path, fmt::format("expected {} points, found {}", points.num_points, i));
    if (points.has_comments && trimmed(*line).starts_with('#')) continue;
    parser.add(*line, lines_before + lines.line(), builder);
    ++i;
  }
}

void check_is_text(const FileBytes& file) {
  constexpr std::size_t kNumChecked = 4096;
  const std::size_t zero = std::string_view(file.bytes).substr(0, kNumChecked).find('\0');
  if (zero != std::string_view::npos) throw io_error_at_byte(file.path, zero, "expected text, found a zero byte");
}

}  // namespace augicp
