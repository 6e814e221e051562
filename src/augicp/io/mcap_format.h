// SPDX-License-Identifier: MIT
// Marks of an MCAP file and of its records. Internal.
#pragma once

#include <cstdint>
#include <string_view>

namespace augicp::mcap {

inline constexpr std::string_view kMagic = "\x89MCAP0\r\n";

enum Opcode : std::uint8_t {
  kHeader = 1,
  kFooter = 2,
  kSchema = 3,
  kChannel = 4,
  kMessage = 5,
  kChunk = 6,
  kMessageIndex = 7,
  kChunkIndex = 8,
  kStatistics = 11,
  kSummaryOffset = 14,
  kDataEnd = 15
};

}  // namespace augicp::mcap
