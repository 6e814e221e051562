// SPDX-License-Identifier: MIT
// The words of enumerators: one table an enumeration, read by the command, its files, and Python.
#pragma once

#include <array>
#include <optional>
#include <string_view>

namespace augicp {

template <typename Value>
struct Word {
  Value value;
  std::string_view word;  // lower case, with underscores
};

// All words of an enumeration. Each enumeration that has words specialises it, below its declaration, with a
// std::array<Word<Value>, N> in the order of its enumerators.
template <typename Value>
inline constexpr std::array<Word<Value>, 0> kWords{};

template <typename Value>
concept HasWords = !kWords<Value>.empty();

// The word of an enumerator; empty for a value that is none.
template <HasWords Value>
constexpr std::string_view name_of(Value value) {
  for (const auto& [known, word] : kWords<Value>)
    if (known == value) return word;
  return {};
}

// The enumerator of a word, if there is one.
template <HasWords Value>
constexpr std::optional<Value> value_of(std::string_view word) {
  for (const auto& [value, known] : kWords<Value>)
    if (known == word) return value;
  return std::nullopt;
}

}  // namespace augicp
