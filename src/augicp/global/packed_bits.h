// SPDX-License-Identifier: MIT
// Conditions of 64 things as the bits of a word, for vectorised loops. Internal.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "augicp/core/vectorized.h"

namespace augicp {

inline constexpr std::size_t kBitsPerWord = 64;

// Numbers are combined without a branch.
AUGICP_INLINE std::int32_t number(bool is_true) { return is_true ? 1 : 0; }

// Bit k is set if number k is 1. REQUIRES: kBitsPerWord numbers, each 0 or 1.
AUGICP_INLINE std::uint64_t packed_bits(const std::int32_t* is_set) {
  constexpr std::size_t kHalf = kBitsPerWord / 2;
  std::uint32_t low = 0, high = 0;
  for (std::size_t k = 0; k < kHalf; ++k) low |= static_cast<std::uint32_t>(-is_set[k]) & (std::uint32_t{1} << k);
  for (std::size_t k = 0; k < kHalf; ++k)
    high |= static_cast<std::uint32_t>(-is_set[k + kHalf]) & (std::uint32_t{1} << k);
  return low | static_cast<std::uint64_t>(high) << kHalf;
}

// Appends the numbers of the set bits of word number `word`, in ascending order.
inline void append_set_bits(std::uint64_t bits, std::size_t word, std::vector<std::uint32_t>& numbers) {
  for (; bits != 0; bits &= bits - 1)
    numbers.push_back(
        static_cast<std::uint32_t>(word * kBitsPerWord + static_cast<std::size_t>(std::countr_zero(bits))));
}

}  // namespace augicp
