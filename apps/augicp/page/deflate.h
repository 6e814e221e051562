// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace augicp::app {

// In the zlib format of RFC 1950. The same bytes for the same input and version of zlib.
std::vector<std::byte> deflated(std::span<const std::uint8_t> bytes);

}  // namespace augicp::app
