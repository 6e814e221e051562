// SPDX-License-Identifier: MIT
// What holds for every table of options.
#pragma once

#include <gmock/gmock.h>

#include <algorithm>
#include <iterator>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "augicp/core/option.h"

namespace augicp {

template <typename Value>
constexpr bool kIsOptional = false;
template <typename Value>
constexpr bool kIsOptional<std::optional<Value>> = true;

// Another value of the same type.
inline void change(double& value) { value = value == 1.0 ? 2.0 : 1.0; }
inline void change(int& value) { ++value; }
inline void change(bool& value) { value = !value; }
template <HasWords Value>
void change(Value& value) {
  value = kWords<Value>.front().value == value ? kWords<Value>.back().value : kWords<Value>.front().value;
}
template <typename Value>
void change(std::optional<Value>& value) {
  value ? value.reset() : void(value.emplace());
}

// Python's keywords in lower case.
inline bool is_python_keyword(std::string_view word) {
  static constexpr std::string_view kKeywords[] = {
      "and",  "as",     "assert",  "async", "await",  "break",    "class", "continue", "def",  "del",  "elif",
      "else", "except", "finally", "for",   "from",   "global",   "if",    "import",   "in",   "is",   "lambda",
      "not",  "or",     "pass",    "raise", "return", "nonlocal", "try",   "while",    "with", "yield"};
  return std::find(std::begin(kKeywords), std::end(kKeywords), word) != std::end(kKeywords);
}

// Lower-case letters and digits in words with single underscores between them, a letter first. A word that Python keeps
// for itself has one more underscore, as PEP 8 has it.
inline bool is_snake_case(std::string name) {
  if (name.ends_with('_') && is_python_keyword(name.substr(0, name.size() - 1))) name.pop_back();
  const auto is_letter = [](char c) { return c >= 'a' && c <= 'z'; };
  const auto is_allowed = [&](char c) { return is_letter(c) || (c >= '0' && c <= '9') || c == '_'; };
  return !name.empty() && is_letter(name.front()) && name.back() != '_' && name.find("__") == std::string::npos &&
         std::all_of(name.begin(), name.end(), is_allowed);
}

template <typename Options>
void expect_sound_texts(const Options& options) {
  std::set<std::string> names, flags;
  for_each_option(options, [&](const OptionText& text, const auto& field) {
    const std::string name(text.name);
    EXPECT_TRUE(names.insert(name).second && flags.insert(flag_name(text)).second) << name << " is there twice";
    EXPECT_TRUE(is_snake_case(name)) << name;
    EXPECT_FALSE(text.group.empty() || text.help.empty()) << name;
    EXPECT_FALSE(text.help.ends_with('.') || text.help.ends_with("metres") || text.help.ends_with("seconds")) << name;
    constexpr bool is_optional = kIsOptional<std::remove_cvref_t<decltype(field)>>;
    EXPECT_FALSE(is_optional && text.unset.empty()) << name;
  });
}

// The line of each option is about a field of its own: what is set through it is read through it, and nothing else
// changes.
template <typename Options>
void expect_fields_of_their_own() {
  const Options usual;
  std::vector<std::string> all;
  for_each_option(usual, [&](const OptionText& text, const auto&) { all.emplace_back(text.name); });
  for (const std::string& changed : all) {
    Options options;
    for_each_option(options, [&](const OptionText& text, auto& field) {
      if (text.name == changed) change(field);
    });
    for_each_option(options, [&](const OptionText& text, const auto& field) {
      for_each_option(usual, [&](const OptionText& other, const auto& usual_field) {
        if constexpr (std::is_same_v<decltype(field), decltype(usual_field)>) {
          const bool is_as_expected = text.name != other.name || (field == usual_field) == (text.name != changed);
          EXPECT_TRUE(is_as_expected) << text.name << " when " << changed << " was changed";
        }
      });
    });
  }
}

}  // namespace augicp
