// SPDX-License-Identifier: MIT
#include "augicp/io/stamp_unit.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "augicp/core/median.h"
#include "augicp/io/format.h"
#include "augicp/io/trajectory_file.h"

namespace augicp {
namespace {

struct TimeUnit {
  double per_s;
  const char* name;
};
constexpr TimeUnit kUnits[] = {{1.0, "seconds"}, {1e3, "milliseconds"}, {1e6, "microseconds"}, {1e9, "nanoseconds"}};

// Frames of a sensor are this far apart, seconds. The ends differ by the factor between two units, so that a time fits
// into one unit alone.
constexpr double kMinGap_s = 2e-3, kMaxGap_s = 2.0;

// No sensor that is tracked waits this long, seconds; microseconds at 100 frames a second are as far apart.
constexpr double kAbsurdGap_s = 1e4;

// Frames farther apart than this are rare, seconds; milliseconds at 100 frames a second are as far apart.
constexpr double kRareGap_s = 10.0;

// Seconds since 1970 of the years 1990 and 2100.
constexpr double kFirstDate_s = 631152000.0, kLastDate_s = 4102444800.0;

struct Spacing {
  double gap = 0.0, largest = 0.0;  // the median time between two frames that ascend, 0: none do; the largest stamp
};

Spacing spacing_of(const std::vector<double>& stamps) {
  Spacing spacing;
  std::vector<double> gaps;
  for (std::size_t i = 0; i < stamps.size(); ++i) {
    spacing.largest = std::max(spacing.largest, std::abs(stamps[i]));
    if (i > 0 && stamps[i] > stamps[i - 1]) gaps.push_back(stamps[i] - stamps[i - 1]);
  }
  if (!gaps.empty()) spacing.gap = upper_median(std::move(gaps));
  return spacing;
}

bool is_possible(const Spacing& spacing, double per_s) {
  return spacing.largest / per_s <= kMaxStamp_s && spacing.gap / per_s < kAbsurdGap_s;
}

bool is_likely(const Spacing& spacing, double per_s) {
  const double gap_s = spacing.gap / per_s, date_s = spacing.largest / per_s;
  return (gap_s >= kMinGap_s && gap_s < kMaxGap_s) || (date_s >= kFirstDate_s && date_s <= kLastDate_s);
}

std::string found(const Spacing& spacing) {
  return spacing.gap > 0.0 ? fmt::format("stamps that are {:g} apart and reach {:g}", spacing.gap, spacing.largest)
                           : fmt::format("stamps that reach {:g}", spacing.largest);
}

// Of stamps that cannot be seconds.
TimeUnit unit_of(const Spacing& spacing) {
  std::vector<TimeUnit> fitting;
  for (const TimeUnit& unit : kUnits)
    if (is_possible(spacing, unit.per_s) && is_likely(spacing, unit.per_s)) fitting.push_back(unit);
  if (fitting.size() == 1) return fitting.front();
  std::string guess;
  for (const TimeUnit& unit : fitting) guess += (guess.empty() ? ": " : " or ") + std::string(unit.name);
  throw std::invalid_argument(
      "expected seconds, found " + found(spacing) +
      (guess.empty() ? ", which suit no unit; write them in seconds" : guess + "? Write them in seconds"));
}

// Of stamps that can be seconds.
std::string suspicion(const Spacing& spacing) {
  if (spacing.gap < kRareGap_s || spacing.largest >= kFirstDate_s) return {};
  for (const TimeUnit& unit : kUnits)
    if (is_likely(spacing, unit.per_s))
      return fmt::format("frames are {:g} s apart by their stamps, which are read as seconds; write {} in seconds",
                         spacing.gap, unit.name);
  return {};
}

}  // namespace

std::string bring_into_seconds(std::vector<double>& stamps) {
  const Spacing spacing = spacing_of(stamps);
  if (is_possible(spacing, 1.0)) return suspicion(spacing);
  const TimeUnit unit = unit_of(spacing);
  for (double& stamp : stamps) stamp /= unit.per_s;
  return fmt::format("the stamps are read as {}: as seconds they would be {}", unit.name,
                     spacing.gap > 0.0 ? fmt::format("{:g} s apart", spacing.gap) : "no date of our time");
}

}  // namespace augicp
