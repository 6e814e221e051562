// SPDX-License-Identifier: MIT
#include "apps/augicp/command/number_checks.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>

#include "augicp/io/parse_number.h"

namespace augicp::app {
namespace {

// A problem in words; empty if there is none. The value may be changed.
using Check = std::string (*)(std::string& value);

std::string expected(const char* what, const std::string& value) {
  return fmt::format("expected {}, found '{}'", what, value);
}

bool are_digits(const std::string& text) {
  return !text.empty() && std::all_of(text.begin(), text.end(), [](char c) { return c >= '0' && c <= '9'; });
}

// The digits without the zeros in front, behind which others read octal numbers: 000100 of a file name is a hundred.
std::string without_zeros(const std::string& digits) {
  const std::size_t first = digits.find_first_not_of('0');
  return first == std::string::npos ? "0" : digits.substr(first);
}

std::string whole_problem(std::string& value) {
  const bool is_signed = value.starts_with('-') || value.starts_with('+');
  const std::string digits = is_signed ? value.substr(1) : value;
  if (value.empty() || value.find_first_of("xX") != std::string::npos) return expected("a whole number", value);
  if (!are_digits(digits)) return {};  // the parser's own message
  const std::string least = without_zeros(digits);
  if (!parse_count(least)) return fmt::format("{} is too large", value);
  value = (value.starts_with('-') ? "-" : "") + least;
  return {};
}

std::string count_problem(std::string& value) {
  if (value.starts_with('-') && parse_double(value)) return fmt::format("must not be negative, found {}", value);
  return whole_problem(value);
}

std::string real_problem(std::string& value) {
  if (value.empty() || value.find_first_of("xX") != std::string::npos) return expected("a decimal number", value);
  const auto number = parse_double(value);
  if (number && std::isnan(*number)) return expected("a number", value);
  const bool is_infinite = value.find_first_of("iI") != std::string::npos;  // in words: some options mean it
  if (number && std::isinf(*number) && !is_infinite) return fmt::format("{} is too large", value);
  return {};
}

// By the name of CLI11 for the type of the option; null for words.
Check check_for(const CLI::Option& option) {
  const std::string type = option.get_type_name();
  if (type.starts_with("UINT")) return count_problem;
  if (type.starts_with("INT")) return whole_problem;
  if (type.starts_with("FLOAT")) return real_problem;
  return nullptr;
}

}  // namespace

void check_numbers(CLI::App& app) {
  for (CLI::Option* option : app.get_options())
    if (const Check check = check_for(*option); check && option->get_items_expected_max() > 0)
      option->transform(CLI::Validator([check](std::string& value) { return check(value); }, ""));
  for (CLI::App* subcommand : app.get_subcommands({})) check_numbers(*subcommand);
}

}  // namespace augicp::app
