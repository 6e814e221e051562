// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

namespace augicp {

// Has so many entries brought to the cache, where they will be wanted soon and processors do not expect it: they look
// ahead along a line of memory by themselves, but not beyond a page of it. A hint: nothing but time depends on it.
template <typename Entry>
void prefetch(const Entry* first, std::size_t count) {
  constexpr std::size_t kLineBytes = 64;
  const auto* const bytes = reinterpret_cast<const char*>(first);
  const std::size_t num_bytes = count * sizeof(Entry);
  for (std::size_t k = 0; k < num_bytes; k += kLineBytes) __builtin_prefetch(bytes + k);
  if (num_bytes > 0) __builtin_prefetch(bytes + num_bytes - 1);  // the first need not begin a line
}

}  // namespace augicp
