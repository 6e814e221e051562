// SPDX-License-Identifier: MIT
#include "augicp/io/scan_stamps.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>
#include <stdexcept>

#include "augicp/io/file_bytes.h"
#include "augicp/io/format.h"
#include "augicp/io/parse_number.h"
#include "augicp/io/stamp_unit.h"
#include "augicp/io/text_lines.h"

namespace augicp {
namespace {

namespace fs = std::filesystem;

// Seconds: a number, or the last field "hours:minutes:seconds" of a date; days count through the date's last two
// digits.
std::optional<double> stamp_in(std::string_view line) {
  if (line.find(':') == std::string_view::npos) return parse_double(line);
  std::string_view rest = line;
  const auto date = next_field(rest);
  if (!date || date->size() < 2) return std::nullopt;
  double stamp_s = parse_double(date->substr(date->size() - 2)).value_or(0.0);
  for (const int per_one : {24, 60, 60}) {
    const auto part = next_field(rest, ':');
    const auto value = part ? parse_double(*part) : std::nullopt;
    if (!value) return std::nullopt;
    stamp_s = stamp_s * per_one + *value;
  }
  return stamp_s;
}

std::vector<double> read_stamps(const fs::path& path, std::size_t num_scans) {
  const FileBytes file = read_bytes(path);
  TextLines lines(without_bom(file.bytes));
  std::vector<double> stamps;
  while (const auto line = lines.next_not_blank()) {
    const std::string_view text = trimmed(*line);
    if (text.front() == '#') continue;
    const auto stamp = stamp_in(text);
    if (!stamp || !std::isfinite(*stamp))
      throw io_error_at_line(path, lines.line(), "expected a time in seconds, found " + in_quotes(text));
    stamps.push_back(*stamp);
  }
  if (stamps.size() != num_scans)
    throw io_error(path, fmt::format("expected {} times, one a scan, found {}", num_scans, stamps.size()));
  return stamps;
}

ScanStamps stamps_of_list(const fs::path& path, std::size_t num_scans) {
  ScanStamps found{read_stamps(path, num_scans), true, false, {}};
  try {
    if (const std::string sentence = bring_into_seconds(found.stamps_s); !sentence.empty())
      found.warnings.push_back(path.string() + ": " + sentence);
  } catch (const std::invalid_argument& error) {
    throw io_error(path, error.what());
  }
  return found;
}

std::optional<fs::path> stamps_file(const fs::path& folder, const fs::path& scan) {
  for (const fs::path& place : {scan.parent_path(), scan.parent_path().parent_path(), folder})
    for (const char* name : {"times.txt", "timestamps.txt"})
      if (std::error_code ignored; fs::is_regular_file(place / name, ignored)) return place / name;
  return std::nullopt;
}

// The number at the end of a name: digits, and a decimal point if one is between them.
struct NumberOfName {
  double value = 0.0;
  bool has_point = false;
};

std::optional<NumberOfName> number_of(const fs::path& scan) {
  const std::string stem = scan.stem().string();
  const std::size_t before = stem.find_last_not_of("0123456789.");
  std::string_view number = std::string_view(stem).substr(before == std::string::npos ? 0 : before + 1);
  number.remove_prefix(std::min(number.find_first_not_of('.'), number.size()));
  if (std::count(number.begin(), number.end(), '.') > 1) number.remove_prefix(number.rfind('.') + 1);
  const auto value = parse_double(number);
  if (!value) return std::nullopt;
  return NumberOfName{*value, number.find('.') != std::string_view::npos};
}

bool ascend(const std::vector<double>& numbers) {
  return std::adjacent_find(numbers.begin(), numbers.end(), std::greater_equal<>()) == numbers.end();
}

// Of names whose numbers are stamps. Without any if their unit cannot be told.
ScanStamps stamps_of_names(const fs::path& folder, std::vector<double> numbers) {
  try {
    const std::string sentence = bring_into_seconds(numbers);
    ScanStamps found{std::move(numbers), true, true, {}};
    if (!sentence.empty()) found.warnings.push_back(folder.string() + ": of the names, " + sentence);
    return found;
  } catch (const std::invalid_argument& error) {
    return {{},
            false,
            false,
            {fmt::format("{}: the numbers in the names are not used: {}", folder.string(), error.what())}};
  }
}

// A map beside its scans would be tracked as one of them.
std::string unnumbered_text(const fs::path& folder, std::span<const fs::path> unnumbered, std::size_t num_scans) {
  if (unnumbered.empty() || 2 * unnumbered.size() >= num_scans) return {};
  return fmt::format("{}: without a number in the name are {} of {} scans, the first is {}; they are tracked as well",
                     folder.string(), unnumbered.size(), num_scans, unnumbered.front().filename().string());
}

std::vector<double> at_rate(const std::vector<double>& numbers, std::size_t num_scans, double scans_per_s) {
  std::vector<double> stamps_s;
  for (std::size_t i = 0; i < num_scans; ++i)
    stamps_s.push_back((numbers.empty() ? static_cast<double>(i) : numbers[i]) / scans_per_s);
  return stamps_s;
}

}  // namespace

ScanStamps scan_stamps(const fs::path& folder, std::span<const fs::path> scans, double scans_per_s) {
  if (const auto list = stamps_file(folder, scans.front())) return stamps_of_list(*list, scans.size());
  std::vector<double> numbers;
  std::vector<fs::path> unnumbered;
  std::size_t num_points = 0;
  for (const fs::path& scan : scans) {
    const auto number = number_of(scan);
    if (!number) unnumbered.push_back(scan);
    if (number) numbers.push_back(number->value), num_points += number->has_point;
  }
  if (!unnumbered.empty() || (num_points < scans.size() && !ascend(numbers))) numbers.clear();
  ScanStamps found;
  if (!numbers.empty() && (num_points == scans.size() || numbers.back() > kMaxFrameNumber)) {
    found = stamps_of_names(folder, numbers);
    if (found.are_measured) return found;
    numbers.clear();
  }
  found.stamps_s = at_rate(numbers, scans.size(), scans_per_s);
  if (std::string text = unnumbered_text(folder, unnumbered, scans.size()); !text.empty())
    found.warnings.push_back(std::move(text));
  return found;
}

}  // namespace augicp
