// SPDX-License-Identifier: MIT
// What a file states of its points, for the points that were made of them: each is the mean of several.
#pragma once

#include <cstdint>
#include <vector>

#include "augicp/io/colours.h"

namespace augicp::app {

// For each point of a cloud, the index of the nearest one among others in the same frame. REQUIRES: there is another.
std::vector<std::uint32_t> nearest_rows(const Cloud& cloud, const Cloud& others);

// For each point of a cloud the colour of the nearest of those that have one. Empty if there are no colours.
std::vector<Colour> nearest_colours(const Cloud& cloud, const Cloud& others, const std::vector<Colour>& colours);

}  // namespace augicp::app
