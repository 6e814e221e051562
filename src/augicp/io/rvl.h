// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

namespace augicp {

// The pixels of a depth image in RVL: A. D. Wilson, "Fast Lossless Depth Image Compression", ISS 2017. Empty if the
// bytes are damaged, have fewer pixels than count, or go on behind them.
std::optional<std::vector<std::uint16_t>> rvl_pixels(std::string_view bytes, std::size_t count);

}  // namespace augicp
