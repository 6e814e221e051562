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

bool has_decimal_comma(std::string_view cell) {
  return std::count(cell.begin(), cell.end(), ',') == 1 && cell.find('.') == std::string_view::npos;
}

std::string with_point(std::string_view cell) {
  std::string text(cell);
  std::replace(text.begin(), text.end(), ',', '.');
  return text;
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

  const TextNotes& notes() const { return notes_; }

 private:
  void note_decimals(std::string_view field, std::uint64_t number) {
    if (!reads_commas_) return;
    bool& has_commas = notes_.has_decimal_commas;
    has_commas = has_commas || field.find(',') != std::string_view::npos;
    has_points_ = has_points_ || field.find('.') != std::string_view::npos;
    if (has_commas && has_points_)
      throw io_error_at_line(file_.path, number, "expected either decimal commas or decimal points, found both");
  }

  void add_field(std::size_t index, std::uint64_t number, CloudBuilder& builder) const {
    if (builder.is_dropped(index)) return;
    PointField& field = builder.fields()[index];
    for (std::size_t k = 0; k < field.count; ++k) {
      const std::size_t column = points_.fields[index] + k;
      const std::string_view stored = column < cells_.size() ? cells_[column] : "";
      const bool has_comma = reads_commas_ && has_decimal_comma(stored);
      const std::string cell = has_comma ? with_point(stored) : std::string(stored);
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
      const auto value = reads_commas_ ? parse_with_comma(*field) : parse_double(*field);
      note_decimals(*field, number);
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
    note_count(column, number);
    return values_;
  }

  void note_count(std::size_t count, std::uint64_t number) {
    if (num_first_ == 0) num_first_ = count;
    if (count != num_first_ && notes_.uneven.empty())
      notes_.uneven = fmt::format("line {} has {} values, the first point has {}", number, count, num_first_);
  }

  const FileBytes& file_;
  const TextPoints& points_;
  std::vector<std::size_t> roles_;  // by column
  PointValues values_{};
  std::vector<std::string_view> cells_;
  const bool reads_commas_ = points_.may_have_decimal_commas && points_.separator == ';';
  bool has_points_ = false;
  std::size_t num_first_ = 0;  // values in the first line
  TextNotes notes_;
};

}  // namespace

std::optional<double> parse_with_comma(std::string_view cell) {
  return has_decimal_comma(cell) ? parse_double(with_point(cell)) : parse_double(cell);
}

bool is_comment(std::string_view line) {
  line = trimmed(line);
  return line.starts_with('#') || line.starts_with('%') || line.starts_with("//");
}

TextNotes add_points(const FileBytes& file, const TextPoints& points, TextLines& lines, std::uint64_t lines_before,
                     CloudBuilder& builder) {
  const bool all = points.num_points == std::numeric_limits<std::uint64_t>::max();
  LineParser parser(file, points);
  for (std::uint64_t i = 0; i < points.num_points;) {
    const auto line = lines.next_not_blank();
    if (!line && all) break;
    if (!line) throw io_error(file.path, fmt::format("expected {} points, found {}", points.num_points, i));
    if (points.has_comments && is_comment(*line)) continue;
    parser.add(*line, lines_before + lines.line(), builder);
    ++i;
  }
  return parser.notes();
}

void check_is_text(const FileBytes& file) {
  constexpr std::size_t kNumChecked = 4096;
  const std::size_t zero = std::string_view(file.bytes).substr(0, kNumChecked).find('\0');
  if (zero != std::string_view::npos) throw io_error_at_byte(file.path, zero, "expected text, found a zero byte");
}

}  // namespace augicp
