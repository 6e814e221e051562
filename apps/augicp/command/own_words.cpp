// SPDX-License-Identifier: MIT
#include "apps/augicp/command/own_words.h"

#include <fmt/core.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <limits>
#include <string_view>
#include <vector>

#include "augicp/core/angles.h"
#include "augicp/io/parse_number.h"

namespace augicp::app {
namespace {

// The values between two marks of a text; empty if it has none of them.
std::string between(const std::string& text, const std::string& begin, const std::string& end) {
  const std::size_t from = text.find(begin);
  if (from == std::string::npos) return {};
  const std::size_t first = from + begin.size(), last = text.find(end, first);
  return text.substr(first, last == std::string::npos ? last : last - first);
}

// More words than the command takes: a file to write without its option, or the numbers of one value apart.
std::string too_many(const CLI::App& command, const std::string& words) {
  if (words.find_first_not_of("0123456789+-.,eE ") == std::string::npos)
    return "several numbers for one option go into quotes, as --initial \"0 0 0 0 0 0 1\"";
  std::string taken;
  for (const CLI::Option* option : command.get_options())
    if (option->get_positional()) taken += (taken.empty() ? "" : " ") + option->get_name(true);
  std::string text = fmt::format("{} takes {} and no more; found {} as well", full_name(command), taken, words);
  if (command.get_option_no_throw("--output")) text += ". A file to write follows its option: --output FILE";
  return text;
}

std::string not_a_number(const CLI::App& command, const std::string& name, const std::string& value) {
  const CLI::Option* option = command.get_option_no_throw(name);
  const bool is_whole = option && option->get_type_name().find("INT") != std::string::npos;
  std::string text = fmt::format("{}: expected a {}, found '{}'", name, is_whole ? "whole number" : "number", value);
  if (value.find(',') != std::string::npos) return text + "; decimals follow a point";
  if (std::isdigit(static_cast<unsigned char>(value.front())) && std::isalpha(static_cast<unsigned char>(value.back())))
    text += "; units are not written: lengths are in metres, angles in degrees";
  return text;
}

// A value that the library refuses, by its own name and in its own unit, as require() writes it.
struct LibraryValue {
  std::string name, value;
};

// A number on the command line, and by how much it is larger in the library's unit.
struct Given {
  const CLI::Option* option = nullptr;
  std::string value;  // as it was typed
  double per_unit = 1.0;
};

const CLI::App& called(const CLI::App& app) {
  const auto inner = app.get_subcommands();  // those that were called
  return inner.empty() ? app : called(*inner.front());
}

std::vector<Given> given_numbers(const CLI::App& command) {
  std::vector<Given> numbers;
  for (const CLI::Option* option : command.get_options())
    for (const std::string& value : option->results())
      if (parse_double(value) && !option->get_positional()) numbers.push_back({option, value, 1.0});
  return numbers;
}

// "max-angle-deg" begins "max_angle" and "threads" ends "num_threads": a name and an option share it.
bool share_a_name(const LibraryValue& wrong, const Given& given) {
  std::string name = wrong.name, flag = given.option->get_name().substr(2);
  std::replace(name.begin(), name.end(), '_', '-');
  return name.starts_with(flag) || name.ends_with(flag) || flag.starts_with(name);
}

// Up to the digits that require() writes.
bool is_same(double value, const std::string& written) {
  const double other = parse_double(written).value_or(std::numeric_limits<double>::quiet_NaN());
  return value == other || std::abs(value - other) <= 1e-6 + 1e-9 * std::abs(other);
}

// The option whose value is the refused one in some unit. One that shares its name; of other names only if there is
// one.
Given meant_by(const LibraryValue& wrong, const std::vector<Given>& numbers) {
  std::vector<Given> fitting;
  for (Given given : numbers)
    for (const double per_unit : {1.0, kRadPerDeg, 0.01}) {
      if (!is_same(per_unit * *parse_double(given.value), wrong.value)) continue;
      given.per_unit = per_unit;
      if (share_a_name(wrong, given)) return given;
      fitting.push_back(given);
      break;
    }
  return fitting.size() == 1 ? fitting.front() : Given{};
}

// "--every: must be from 1 to 1000000000, found 0".
std::string out_of_range(const std::string& text) {
  const std::string option = text.substr(0, text.find(": ")), value = between(text, "Value ", " not in range ");
  const auto low = parse_double(between(text, " not in range ", " to ")),
             high = parse_double(between(text, " to ", "\n"));
  if (!low || !high) return text;
  if (*high == std::numeric_limits<double>::max())
    return fmt::format("{}: must be above {:g}, found {}", option, *low, value);
  return fmt::format("{}: must be from {:.12g} to {:.12g}, found {}", option, *low, *high, value);
}

}  // namespace

std::string full_name(const CLI::App& command) {
  return command.get_parent() ? full_name(*command.get_parent()) + " " + command.get_name() : "augicp";
}

std::string in_own_words(const CLI::App& command, const CLI::ParseError& error) {
  const std::string text = error.what();
  if (dynamic_cast<const CLI::ExtrasError*>(&error)) return too_many(command, between(text, "expected: ", "\n"));
  const std::string name = between(text, "convert: ", " = "), value = between(text, " = ", "\n");
  if (dynamic_cast<const CLI::ConversionError*>(&error) && !name.empty() && !value.empty())
    return not_a_number(command, name, value);
  if (text.find(" not in range ") != std::string::npos) return out_of_range(text);
  if (text.ends_with(" missing") && text.starts_with("--"))
    return fmt::format("{}: expected a value behind it", text.substr(0, text.find(':')));
  const std::string option = text.substr(0, text.find(' '));
  const CLI::Option* required = command.get_option_no_throw(option);
  if (dynamic_cast<const CLI::RequiredError*>(&error) && required && required->get_positional())
    return text.substr(text.find_first_not_of('-'));  // without dashes, which nobody writes there
  return text;
}

std::string in_words_of_options(const CLI::App& app, const std::string& message) {
  const std::size_t equals = message.find(" = "), colon = message.find(": ");
  if (equals == std::string::npos || colon == std::string::npos || colon < equals) return message;
  const LibraryValue wrong{message.substr(0, equals), message.substr(equals + 3, colon - equals - 3)};
  const Given given = meant_by(wrong, given_numbers(called(app)));
  if (!given.option) return message;
  std::string requirement = message.substr(colon);
  constexpr std::string_view in_radians = "pi; it is in radians, not degrees";
  if (const std::size_t at = requirement.find(in_radians); at != std::string::npos && given.per_unit == kRadPerDeg)
    requirement.replace(at, in_radians.size(), "180");
  return fmt::format("{} {}{}", given.option->get_name(), given.value, requirement);
}

}  // namespace augicp::app
