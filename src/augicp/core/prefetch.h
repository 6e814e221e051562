// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

namespace augicp {

// Loads `count` entries into the cache before they are needed. Processors prefetch along a line of memory by
// themselves, but not beyond its page. A hint: it changes only time.
template <typename Entry>
void prefetch(const Entry* first, std::size_t count) {
  constexpr std::size_t kLineBytes = 64;
  const auto* const bytes = reinterpret_cast<const char*>(first);
  const std::size_t num_bytes = count * sizeof(Entry);
  for (std::size_t k = 0; k < num_bytes; k += kLineBytes) __builtin_prefetch(bytes + k);
  if (num_bytes > 0) __builtin_prefetch(bytes + num_bytes - 1);  // `first` may lie within a cache line
}

}  // namespace augicp
