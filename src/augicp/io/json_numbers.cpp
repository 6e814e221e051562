// SPDX-License-Identifier: MIT
#include "augicp/io/json_numbers.h"

#include <nlohmann/json.hpp>
#include <stdexcept>

#include "augicp/io/format.h"

namespace augicp {
namespace {

// Lists within lists are written one within the other: too deep ones would overflow the stack.
nlohmann::json object_in(std::string_view what, std::string_view text) {
  constexpr int kDeepest = 32;
  const auto check_depth = [&](int depth, nlohmann::json::parse_event_t, const nlohmann::json&) {
    if (depth > kDeepest)
      throw std::invalid_argument(fmt::format("{}: expected JSON less deep than {}", what, kDeepest));
    return true;
  };
  nlohmann::json json = nlohmann::json::parse(text, check_depth, /*allow_exceptions=*/false);
  const bool has_zero = text.find('\0') != std::string_view::npos;  // the parser would take it for the end
  if (has_zero || !json.is_object()) throw std::invalid_argument(fmt::format("{}: the JSON is damaged", what));
  return json;
}

}  // namespace

std::optional<std::string> json_object(std::string_view what, std::string_view text, const std::string& key) {
  const nlohmann::json json = object_in(what, text);
  const auto value = json.find(key);
  return value != json.end() && value->is_object() ? std::optional(value->dump()) : std::nullopt;
}

std::optional<std::vector<double>> json_numbers(std::string_view what, std::string_view text, const std::string& key) {
  const nlohmann::json json = object_in(what, text);
  const auto value = json.find(key);
  if (value == json.end()) return std::nullopt;

  std::vector<double> numbers;
  const auto append = [&](const nlohmann::json& number) {
    if (!number.is_number()) throw std::invalid_argument(fmt::format("{}: expected numbers in \"{}\"", what, key));
    numbers.push_back(number.get<double>());
  };
  const auto append_row = [&](const nlohmann::json& row) {
    if (!row.is_array()) return append(row);
    for (const nlohmann::json& number : row) append(number);
  };
  if (!value->is_array()) {
    append(*value);
  } else {
    for (const nlohmann::json& row : *value) append_row(row);
  }
  return numbers;
}

}  // namespace augicp
