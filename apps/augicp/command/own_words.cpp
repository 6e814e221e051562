// SPDX-License-Identifier: MIT
#include "apps/augicp/command/own_words.h"

#include <fmt/core.h>

#include <algorithm>
#include <cctype>

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
  if (text.ends_with(" missing") && text.starts_with("--"))
    return fmt::format("{}: expected a value behind it", text.substr(0, text.find(':')));
  const std::string option = text.substr(0, text.find(' '));
  const CLI::Option* required = command.get_option_no_throw(option);
  if (dynamic_cast<const CLI::RequiredError*>(&error) && required && required->get_positional())
    return text.substr(2);  // without the dashes, which nobody writes there
  return text;
}

std::string in_words_of_options(const CLI::App& app, const std::string& message) {
  const std::size_t equals = message.find(" = "), colon = message.find(": ");
  if (equals == std::string::npos || colon == std::string::npos || colon < equals) return message;
  std::string name = message.substr(0, equals), value = message.substr(equals + 3, colon - equals - 3);
  std::replace(name.begin(), name.end(), '_', '-');
  for (const CLI::App* command : app.get_subcommands())  // those that were called
    for (const std::string& option : {"--" + name, name.starts_with("num-") ? "--" + name.substr(4) : "--" + name})
      if (command->get_option_no_throw(option))
        return fmt::format("{} {}{}", option, parse_double(value) ? fmt::format("{:g}", *parse_double(value)) : value,
                           message.substr(colon));
  return message;
}

}  // namespace augicp::app
