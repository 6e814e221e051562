// SPDX-License-Identifier: MIT
// Enumerations with words as choices on the command line.
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "apps/augicp/command/suggestion.h"
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
  const auto to_number = [](std::string& given) {
    for (const auto& [value, word] : kWords<Value>) {
      if (given != word) continue;
      given = std::to_string(static_cast<int>(value));  // the parser knows enumerators by number
      return std::string();
    }
    std::vector<std::string> words;
    for (const auto& [value, word] : kWords<Value>) words.emplace_back(word);
    const std::string near = closest(given, words);
    return "expected one of " + choices<Value>() + ", found '" + given + "'" +
           (near.empty() ? "" : ". Did you mean " + near + "?");
  };
  return CLI::Validator(to_number, choices<Value>());
}

}  // namespace augicp::app
