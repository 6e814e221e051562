// SPDX-License-Identifier: MIT
#include "apps/augicp/page/thinning.h"

#include <numeric>

namespace augicp::app {
namespace {

// A bijection of 32 bits that leaves no visible order (the finaliser of MurmurHash3).
std::uint32_t scrambled(std::uint32_t x) {
  x = (x ^ x >> 16) * 0x85ebca6bu;
  x = (x ^ x >> 13) * 0xc2b2ae35u;
  return x ^ x >> 16;
}

}  // namespace

std::vector<std::uint32_t> thinned_indices(std::size_t count, std::size_t max_count) {
  std::vector<std::uint32_t> indices(count < max_count ? count : max_count);
  if (count <= max_count) {
    std::iota(indices.begin(), indices.end(), 0u);
    return indices;
  }
  for (std::size_t i = 0; i < max_count; ++i) {
    const std::size_t begin = i * count / max_count, end = (i + 1) * count / max_count;
    indices[i] = static_cast<std::uint32_t>(begin + scrambled(static_cast<std::uint32_t>(i)) % (end - begin));
  }
  return indices;
}

}  // namespace augicp::app
