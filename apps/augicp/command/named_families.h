// SPDX-License-Identifier: MIT
// The families of an experiment by their names on the command line.
#pragma once

#include <fmt/core.h>

#include <algorithm>
#include <stdexcept>
#include <string>
#include <vector>

namespace augicp::app {

// Those with these names, in their order; all if none is given. Throws std::invalid_argument, which lists the families,
// if a name is not one of them.
template <typename Family>
std::vector<Family> named_families(const std::vector<Family>& families, const std::vector<std::string>& names) {
  if (names.empty()) return families;
  std::vector<Family> found;
  for (const std::string& name : names) {
    const auto at = std::find_if(families.begin(), families.end(), [&](const Family& one) { return one.name == name; });
    if (at == families.end()) {
      std::string known;
      for (const Family& family : families) known += "\n  " + family.name;
      throw std::invalid_argument(fmt::format("no family is named \"{}\". The families are:{}", name, known));
    }
    found.push_back(*at);
  }
  return found;
}

}  // namespace augicp::app
