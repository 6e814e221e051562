// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace augicp::app {

// The number of letters to insert, drop, replace or swap with their neighbour, so that a becomes b (optimal string
// alignment).
std::size_t edit_distance(std::string_view a, std::string_view b);

// The known name that somebody probably meant by a word; empty if none is near. Dashes, underscores and capitals do not
// matter. Near is: a third of the letters differ at most, the word begins the name, or the word has all parts of the
// name ("max-correspondence-distance": "max-distance"), or other programs call it so ("leaf-size": "voxel-size"). Of
// equally near names the first.
std::string closest(const std::string& word, const std::vector<std::string>& known);

}  // namespace augicp::app
