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
  for (std::size_t k = 0; k < count * sizeof(Entry); k += kLineBytes) __builtin_prefetch(bytes + k);
}

}  // namespace augicp
