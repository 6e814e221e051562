// SPDX-License-Identifier: MIT
// Sizes of blocks for loops that fit a surface at each item: some microseconds each. Internal.
#pragma once

#include <cstddef>

namespace augicp {

inline constexpr std::size_t kPointsPerBlock = 256;
inline constexpr std::size_t kRowsPerBlock = 8;  // of an image

}  // namespace augicp
