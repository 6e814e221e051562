// SPDX-License-Identifier: MIT
// The nearest of the points that a query meets. Internal.
#pragma once

#include <array>
#include <bit>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "augicp/search/kd_nodes.h"

namespace augicp {

// A squared distance and, below it, an index, as one number. The nearer of two points has the lower rank, and of two
// equally near points the one with the lower index. (The bit patterns of non-negative floats are in the order of their
// values.)
using Rank = std::int64_t;
constexpr Rank rank_of(float distance_sq, std::uint32_t index) {
  return Rank{std::bit_cast<std::int32_t>(distance_sq)} << 32 | index;
}
constexpr std::uint32_t index_of(Rank rank) { return static_cast<std::uint32_t>(rank); }
constexpr float distance_sq_of(Rank rank) { return std::bit_cast<float>(static_cast<std::int32_t>(rank >> 32)); }

// No point: above the rank of every point.
inline constexpr Rank kMissing =
    rank_of(std::numeric_limits<float>::infinity(), std::numeric_limits<std::uint32_t>::max());

// The lowest ranks of those added. Ranks are collected unsorted, and sorted by comparing each with each when enough
// have gathered. Insertion into a sorted list is slower, because the processor cannot predict the place.
inline constexpr std::size_t kFewRanks = 64;
class FirstFew {
 public:
  // count: above 0. limit: only lower ranks are kept.
  FirstFew(std::size_t count, Rank limit);
  FirstFew(const FirstFew&) = delete;
  FirstFew& operator=(const FirstFew&) = delete;

  // Ranks at or above this are not among the lowest.
  Rank limit() const { return limit_; }

  // Adds the points of a leaf, given their squared distances.
  void add(const KdLeaf& leaf, const std::array<float, KdLeaf::kPoints>& distances_sq);

  // In ascending order; fewer than count if fewer were added.
  std::span<const Rank> sorted();

 private:
  void keep_first();

  std::size_t count_, enough_;  // enough_: the number of ranks at which they are sorted
  std::array<Rank, kFewRanks> few_;
  std::vector<Rank> many_;  // used instead if count is large
  Rank* ranks_;
  std::size_t num_ranks_ = 0;
  Rank limit_;
};

}  // namespace augicp
