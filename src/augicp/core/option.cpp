// SPDX-License-Identifier: MIT
#include "augicp/core/option.h"

#include <algorithm>

namespace augicp {
namespace {

std::string_view suffix_of(Unit unit) {
  if (unit == Unit::Seconds) return "_s";
  if (unit == Unit::Gigabytes) return "_gb";
  return unit == Unit::Chi2 ? "_chi2" : "";
}

}  // namespace

std::string outer_name(const OptionText& text) {
  std::string_view name = text.name;
  if (name.ends_with('_')) name.remove_suffix(1);
  return std::string(name) + (outer_unit(text.unit) == Unit::Degrees ? "_deg" : "");
}

std::string flag_name(const OptionText& text) {
  std::string name = outer_name(text);
  if (const std::string_view suffix = suffix_of(text.unit); name.ends_with(suffix))
    name.resize(name.size() - suffix.size());
  std::replace(name.begin(), name.end(), '_', '-');
  return name;
}

std::string described(const OptionText& text, Unit shown) {
  std::string line(text.help);
  if (shown != Unit::None) line += ", " + std::string(name_of(shown));
  if (!text.unset.empty()) line += " (default: " + std::string(text.unset) + ")";
  return line;
}

}  // namespace augicp
