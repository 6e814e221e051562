// SPDX-License-Identifier: MIT
// How often dear tests repeat themselves. More seeds, trials and rounds test numbers against chance: the optimised
// build runs all of them. Sanitizers look for wrong accesses, in code that the first repetition runs through, and take
// ten times as long; there a few repetitions do.
#pragma once

#include <cstddef>
#include <initializer_list>
#include <vector>

namespace augicp::testing {

#ifdef AUGICP_SANITIZED
inline constexpr bool kIsSanitized = true;
#else
inline constexpr bool kIsSanitized = false;
#endif

constexpr int repeats(int full, int sanitized) { return kIsSanitized ? sanitized : full; }

// All of them, or the first few under sanitizers.
template <typename T>
std::vector<T> cases(std::initializer_list<T> full, std::size_t num_sanitized) {
  return {full.begin(), kIsSanitized ? full.begin() + num_sanitized : full.end()};
}

}  // namespace augicp::testing
