// SPDX-License-Identifier: MIT
#include "apps/augicp/command/point_times.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "augicp/io/file_bytes.h"
#include "augicp/io/time_field.h"

namespace augicp::app {
namespace {

namespace fs = std::filesystem;

// The usual time between two scans, where their stamps do not tell.
constexpr double kUsualGap_s = 0.1;

constexpr const char* kAuto = "auto";

ReadOptions with_fields() {
  ReadOptions options;
  options.keep_fields = true;
  return options;
}

struct FirstScan {
  fs::path path;
  CloudFile content;
};

// Skips scans that cannot be read: tracking reports them. If none can be read, throws the last one's error.
FirstScan first_readable(const ScanSequence& sequence, std::span<const std::size_t> chosen) {
  ScanReader reader(sequence);
  for (const std::size_t scan : chosen) try {
      return {sequence.scans[scan].path, reader.read(scan, with_fields())};
    } catch (const IoError&) {
      if (scan == chosen.back()) throw;
    }
  return {};
}

double gap_s(const ScanSequence& sequence, std::span<const std::size_t> chosen) {
  double shortest = 0.0;
  for (std::size_t i = 1; i < chosen.size(); ++i) {
    const double gap = sequence.scans[chosen[i]].stamp_s - sequence.scans[chosen[i - 1]].stamp_s;
    if (gap > 0.0 && (shortest == 0.0 || gap < shortest)) shortest = gap;
  }
  return shortest > 0.0 ? shortest : kUsualGap_s;
}

std::string unit_in_words(double unit_s) {
  return unit_s == 1.0 ? "seconds" : unit_s == 1e-3 ? "milliseconds" : unit_s == 1e-6 ? "microseconds" : "nanoseconds";
}

SweepShares shares_of_field(const CloudFile& scan, const fs::path& path, const std::string& name) {
  const PointField* field = find_time_field(scan, name);
  if (!field) throw io_error(path, fmt::format("expected a field {}, found none", in_quotes(name)));
  const std::vector<double> times = values_of_points(scan, *field);
  for (const double time : times)
    if (!std::isfinite(time))
      throw io_error(path, fmt::format("expected finite times in the field {}, found {}", in_quotes(name), time));
  return shares_from_times(times);
}

// Empty where the times are all the same.
std::optional<PointTimes> from_field(const FirstScan& scan, const PointField& field, double expected_s) {
  if (shares_of_field(scan.content, scan.path, field.name).empty()) return std::nullopt;
  const std::vector<double> times = values_of_points(scan.content, field);
  const auto [first, last] = std::minmax_element(times.begin(), times.end());
  const auto unit_s = likely_time_unit_s(*last - *first, expected_s);
  if (!unit_s)
    throw io_error(scan.path, fmt::format("expected times of a sweep of about {:.3g} s, the time between two scans by "
                                          "their stamps, in the field {}, found {} to {}",
                                          expected_s, in_quotes(field.name), *first, *last));
  const double sweep_s = (*last - *first) * *unit_s;
  return PointTimes{PointTimes::Source::Field, field.name, sweep_s,
                    fmt::format("field {}, {}: sweeps of {:.4g} s", field.name, unit_in_words(*unit_s), sweep_s)};
}

PointTimes guessed(const ScanSequence& sequence, std::span<const std::size_t> chosen) {
  const FirstScan scan = first_readable(sequence, chosen);
  if (const PointField* field = find_time_field(scan.content, ""))
    if (const auto times = from_field(scan, *field, gap_s(sequence, chosen))) return *times;
  const bool is_ordered = !shares_from_order(scan.content.cloud).empty();
  return {PointTimes::Source::Order, {}, 0.0, is_ordered ? "by the order of the points" : "unknown"};
}

}  // namespace

PointTimes point_times_of(const ScanSequence& sequence, std::span<const std::size_t> chosen, const std::string& given) {
  if (given == "none") return {PointTimes::Source::None, {}, 0.0, "none"};
  if (given == "azimuth") return {PointTimes::Source::Azimuth, {}, 0.0, "by the azimuth"};
  if (given == kAuto) return guessed(sequence, chosen);
  const FirstScan scan = first_readable(sequence, chosen);
  const PointField* field = find_time_field(scan.content, given);
  if (!field) throw io_error(scan.path, fmt::format("expected a field {}, found none", in_quotes(given)));
  if (const auto times = from_field(scan, *field, gap_s(sequence, chosen))) return *times;
  throw io_error(scan.path, fmt::format("expected times in the field {}, found one value only", in_quotes(given)));
}

ReadOptions read_options_for(const PointTimes& times) {
  return times.source == PointTimes::Source::Field ? with_fields() : ReadOptions{};
}

SweepShares shares_of(const CloudFile& scan, const fs::path& path, const PointTimes& times) {
  switch (times.source) {
    case PointTimes::Source::Field:
      return shares_of_field(scan, path, times.field);
    case PointTimes::Source::Order:
      return shares_from_order(scan.cloud);
    case PointTimes::Source::Azimuth:
      return shares_from_azimuth(scan.cloud);
    case PointTimes::Source::None:
      break;
  }
  return {};
}

}  // namespace augicp::app
