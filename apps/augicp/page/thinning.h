// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace augicp::app {

// At most max_count of the indices 0 .. count - 1, ascending: one from each of equally long stretches, at a
// pseudo-random but fixed place within it. Every n-th pixel of an image would give stripes.
std::vector<std::uint32_t> thinned_indices(std::size_t count, std::size_t max_count);

}  // namespace augicp::app
