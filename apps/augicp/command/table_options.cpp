// SPDX-License-Identifier: MIT
#include "apps/augicp/command/table_options.h"

#include <fmt/core.h>

#include <cmath>

namespace augicp::app {
namespace {

template <typename Field>
CLI::Option* add_number(CLI::App& command, const OptionText& text, Field& field) {
  const auto set = [&field, unit = text.unit](const double& value) { field = inner_value(unit, value); };
  return command.add_option_function<double>("--" + flag_name(text), set, described(text, outer_unit(text.unit)))
      ->group(std::string(text.group));
}

}  // namespace

void add_table_option(CLI::App& command, const OptionText& text, double& field) {
  CLI::Option* const option = add_number(command, text, field);
  if (std::isfinite(field)) option->default_str(fmt::format("{:.6g}", outer_value(text.unit, field)));
}

void add_table_option(CLI::App& command, const OptionText& text, std::optional<double>& field) {
  add_number(command, text, field);
}

void add_table_option(CLI::App& command, const OptionText& text, int& field) {
  add_described(command, text, field)->capture_default_str();
}

void add_table_option(CLI::App& command, const OptionText& text, bool& field) {
  const std::string name = flag_name(text);
  const std::string help = described(text, outer_unit(text.unit)) + (field ? " (default: on)" : " (default: off)");
  command.add_flag("--" + name + ",!--no-" + name, field, help)->group(std::string(text.group));
}

}  // namespace augicp::app
