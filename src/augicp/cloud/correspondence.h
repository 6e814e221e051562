// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

namespace augicp {

// A pair (j, i) of the paper: indices of a source and of a target point taken to be the same piece of surface.
struct Correspondence {
  std::uint32_t source = 0;
  std::uint32_t target = 0;
  bool operator==(const Correspondence&) const = default;
};

}  // namespace augicp
