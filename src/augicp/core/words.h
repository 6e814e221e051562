// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <string>

namespace augicp {

// The word of a value in a table; empty if the table lacks the value.
template <typename Value>
std::string word_for(const std::map<std::string, Value>& words, Value value) {
  for (const auto& [word, meaning] : words)
    if (meaning == value) return word;
  return {};
}

}  // namespace augicp
