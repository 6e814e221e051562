// SPDX-License-Identifier: MIT
// Options of the library's tables (augicp/core/option.h) as options of a subcommand.
#pragma once

#include <CLI/CLI.hpp>
#include <algorithm>
#include <optional>
#include <stdexcept>
#include <string_view>
#include <vector>

#include "apps/augicp/command/choice.h"
#include "augicp/core/option.h"

namespace augicp::app {

// One option; field must outlive the command.
void add_table_option(CLI::App& command, const OptionText& text, double& field);
void add_table_option(CLI::App& command, const OptionText& text, int& field);
void add_table_option(CLI::App& command, const OptionText& text, bool& field);
void add_table_option(CLI::App& command, const OptionText& text, std::optional<double>& field);

// The name, description and group that every option has.
template <typename Field>
CLI::Option* add_described(CLI::App& command, const OptionText& text, Field& field) {
  return command.add_option("--" + flag_name(text), field, described(text, outer_unit(text.unit)))
      ->group(std::string(text.group));
}

template <HasWords Value>
void add_table_option(CLI::App& command, const OptionText& text, Value& field) {
  add_described(command, text, field)->transform(choice<Value>())->default_str(std::string(name_of(field)));
}

template <HasWords Value>
void add_table_option(CLI::App& command, const OptionText& text, std::optional<Value>& field) {
  add_described(command, text, field)->transform(choice<Value>());
}

// Every option of the table, with the values in options as defaults.
template <typename Options>
void add_all_options(CLI::App& command, Options& options) {
  for_each_option(options, [&](const OptionText& text, auto& field) { add_table_option(command, text, field); });
}

// Those with these names, in the order of the table. Throws std::logic_error for a name that is not in it.
template <typename Options>
void add_options(CLI::App& command, Options& options, const std::vector<std::string_view>& names) {
  std::size_t num_added = 0;
  for_each_option(options, [&](const OptionText& text, auto& field) {
    if (std::find(names.begin(), names.end(), text.name) == names.end()) return;
    add_table_option(command, text, field);
    ++num_added;
  });
  if (num_added != names.size()) throw std::logic_error("an option is named that the table lacks");
}

}  // namespace augicp::app
