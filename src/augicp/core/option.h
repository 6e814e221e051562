// SPDX-License-Identifier: MIT
// How an option is named and described, once for the command, Python, JSON and reports.
//
// Each options struct has a table, a function for_each_option(options, visit) in its module's option_table.h. It calls
// visit(const OptionText&, field) for each option, in the order in which they are shown; a field is a double, an int, a
// bool, an enumeration with words, or a std::optional of one of these. A new option is a new line there. Values,
// defaults and ranges are the struct's own.
#pragma once

#include <concepts>
#include <numbers>
#include <string>
#include <string_view>
#include <type_traits>

#include "augicp/core/words.h"

namespace augicp {

enum class Unit { None, Metres, Radians, Degrees, Seconds, Chi2, Gigabytes };
template <>
inline constexpr auto kWords<Unit> = std::to_array<Word<Unit>>({{Unit::None, ""},
                                                                {Unit::Metres, "metres"},
                                                                {Unit::Radians, "radians"},
                                                                {Unit::Degrees, "degrees"},
                                                                {Unit::Seconds, "seconds"},
                                                                {Unit::Chi2, "in units of chi2"},
                                                                {Unit::Gigabytes, "GB"}});

struct OptionText {
  // The keyword in Python; ends in _s for seconds, in _chi2 for units of chi2 and in _gb for gigabytes, and in _ if it
  // is a reserved word.
  std::string_view name;
  Unit unit = Unit::None;
  std::string_view group;       // heading in help texts
  std::string_view help;        // without unit, default and full stop
  std::string_view unset = {};  // where a std::optional that is not set takes its value from; also for infinity
};

// The unit on the command line, in JSON and in reports: degrees for radians.
constexpr Unit outer_unit(Unit unit) { return unit == Unit::Radians ? Unit::Degrees : unit; }

// A value of a field in that unit, and back.
constexpr double outer_value(Unit unit, double value) {
  return unit == Unit::Radians ? value * 180.0 / std::numbers::pi : value;
}
constexpr double inner_value(Unit unit, double value) {
  return unit == Unit::Radians ? value * std::numbers::pi / 180.0 : value;
}

// The name in JSON and reports: with _deg if they have degrees, without the _ of a reserved word.
std::string outer_name(const OptionText& text);

// The name on the command line, without the dashes before it: max-angle-deg, time-offset, kernel.
std::string flag_name(const OptionText& text);

// One line for people: "Pairs farther apart are dropped, metres (default: derived)".
std::string described(const OptionText& text, Unit shown);

// Table or const Table: a visitor may change the fields of the first.
template <typename Options, typename Table>
concept OptionsOf = std::same_as<std::remove_const_t<Options>, Table>;

}  // namespace augicp
