// SPDX-License-Identifier: MIT
// Vectors for the few loops that compilers do not vectorise.
#pragma once

#include "augicp/core/vectorized.h"

namespace augicp {

// Vectors of this many bytes. A machine without such vectors uses several smaller ones. Never pass them by value.
template <typename Number, int kBytes>
struct Vectors {
  using Vector [[gnu::vector_size(kBytes)]] = Number;
  static constexpr int kLanes = kBytes / static_cast<int>(sizeof(Number));
};
template <typename Number>
using Wide = Vectors<Number, 32>;

// Loads from unaligned arrays. Not by memcpy(): gcc copies two halves and then waits for both.
template <typename Vector, typename Number>
AUGICP_INLINE void load(const Number* from, Vector& vector) {
  using Unaligned [[gnu::vector_size(sizeof(Vector)), gnu::aligned(alignof(Number)), gnu::may_alias]] = Number;
  vector = *reinterpret_cast<const Unaligned*>(from);
}
template <typename Vector, typename Number>
AUGICP_INLINE void store(const Vector& vector, Number* to) {
  using Unaligned [[gnu::vector_size(sizeof(Vector)), gnu::aligned(alignof(Number)), gnu::may_alias]] = Number;
  *reinterpret_cast<Unaligned*>(to) = vector;
}

}  // namespace augicp
