// SPDX-License-Identifier: MIT
// Enumerations with words as choices on the command line.
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <utility>
#include <vector>

#include "augicp/core/words.h"

namespace augicp::app {

// "{augmented,gicp,plane,point,ndt}"
template <HasWords Value>
std::string choices() {
  std::string text;
  for (const auto& [value, word] : kWords<Value>) text += (text.empty() ? "{" : ",") + std::string(word);
  return text + "}";
}

// Takes a word, and refuses others with the words that there are.
template <HasWords Value>
CLI::Validator choice() {
  std::vector<std::pair<std::string, Value>> words;
  for (const auto& [value, word] : kWords<Value>) words.emplace_back(word, value);
  return CLI::CheckedTransformer(words).description(choices<Value>());
}

}  // namespace augicp::app
