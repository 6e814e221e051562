// SPDX-License-Identifier: MIT
// Options of the library's tables (augicp/core/option.h) as JSON.
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "augicp/core/option.h"

namespace augicp::app {

// Angles in degrees; a choice by its word.
template <typename Value>
nlohmann::ordered_json field_json(Unit unit, const Value& field) {
  if constexpr (HasWords<Value>)
    return std::string(name_of(field));
  else if constexpr (std::is_same_v<Value, double>)
    return outer_value(unit, field);
  else
    return field;
}

// null if it is not set.
template <typename Value>
nlohmann::ordered_json field_json(Unit unit, const std::optional<Value>& field) {
  return field ? field_json(unit, *field) : nlohmann::ordered_json(nullptr);
}

// Every option of the table by its name.
template <typename Options>
nlohmann::ordered_json options_json(const Options& options) {
  nlohmann::ordered_json json = nlohmann::ordered_json::object();
  for_each_option(options, [&](const OptionText& text, const auto& field) {
    json[outer_name(text)] = field_json(text.unit, field);
  });
  return json;
}

}  // namespace augicp::app
