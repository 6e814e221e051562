// SPDX-License-Identifier: MIT
#include "augicp/io/reference_pairs_file.h"

#include <array>
#include <cmath>
#include <optional>
#include <span>
#include <stdexcept>

#include "augicp/io/format.h"
#include "augicp/io/parse_number.h"
#include "augicp/io/pose_numbers.h"
#include "augicp/io/text_lines.h"
#include "augicp/io/text_points.h"

namespace augicp {
namespace {

constexpr const char* kPairColumns = "i j tx ty tz qx qy qz qw";
constexpr double kMaxPlace = 1e9;

std::size_t place_of(double value) {
  if (value >= 0.0 && value <= kMaxPlace && value == std::floor(value)) return static_cast<std::size_t>(value);
  throw std::invalid_argument(fmt::format("expected the place of a pose, from 0, found {}", value));
}

ReferencePair pair_in(std::string_view content) {
  std::array<double, 9> values{};
  const char separator = separator_of(content);
  std::string_view rest = content;
  for (double& value : values) {
    const auto field = next_field(rest, separator);
    const std::optional<double> number = field ? parse_double(*field) : std::nullopt;
    if (!number) throw std::invalid_argument(fmt::format("expected {}, found {}", kPairColumns, in_quotes(content)));
    value = *number;
  }
  const ReferencePair pair{place_of(values[0]), place_of(values[1]),
                           pose_of_numbers("motion", std::span<const double, 9>(values).subspan<2>())};
  if (pair.first >= pair.second)
    throw std::invalid_argument(fmt::format("expected i < j, found {} and {}", pair.first, pair.second));
  return pair;
}

}  // namespace

std::vector<ReferencePair> parse_reference_pairs(const FileBytes& file) {
  check_is_text(file);
  std::vector<ReferencePair> pairs;
  TextLines lines(without_bom(file.bytes));
  while (const auto line = lines.next()) {
    const std::string_view content = trimmed(line->substr(0, line->find('#')));
    if (content.empty()) continue;
    try {
      pairs.push_back(pair_in(content));
    } catch (const std::invalid_argument& fault) {
      throw io_error_at_line(file.path, lines.line(), fault.what());
    }
  }
  if (pairs.empty())
    throw io_error(file.path, fmt::format("expected known motions, {} a line, found none", kPairColumns));
  return pairs;
}

std::vector<ReferencePair> read_reference_pairs(const std::filesystem::path& path) {
  constexpr std::uint64_t kMaxBytes = std::uint64_t{1} << 28;
  return parse_reference_pairs(read_bytes(path, kMaxBytes));
}

}  // namespace augicp
