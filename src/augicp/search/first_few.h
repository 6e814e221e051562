// SPDX-License-Identifier: MIT
// The nearest of the points that a query comes across. Not for users of the library.
#pragma once

#include <array>
#include <bit>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "augicp/search/kd_nodes.h"

namespace augicp {

// A squared distance and, below it, an index as one number: of two points the nearer one has the lower, of two equally
// near ones that with the lower index. The bits of floats that are not negative are ordered as they are.
using Rank = std::int64_t;
constexpr Rank rank_of(float distance_sq, std::uint32_t index) {
  return Rank{std::bit_cast<std::int32_t>(distance_sq)} << 32 | index;
}
constexpr std::uint32_t index_of(Rank rank) { return static_cast<std::uint32_t>(rank); }
constexpr float distance_sq_of(Rank rank) { return std::bit_cast<float>(static_cast<std::int32_t>(rank >> 32)); }

// Where there is no point: above those of all points.
inline constexpr Rank kMissing =
    rank_of(std::numeric_limits<float>::infinity(), std::numeric_limits<std::uint32_t>::max());

// The lowest ranks of those that were added. They are collected as they come, and sorted when many have gathered, by
// comparing each with each: an insertion into a sorted list costs more, for the processor cannot guess where it will
// be.
inline constexpr std::size_t kFewRanks = 64;
class FirstFew {
 public:
  explicit FirstFew(std::size_t count);  // above 0
  FirstFew(const FirstFew&) = delete;
  FirstFew& operator=(const FirstFew&) = delete;

  // Ranks from here on are none of the lowest.
  Rank limit() const { return limit_; }

  // Those of a leaf's points, given their squared distances.
  void add(const KdLeaf& leaf, const std::array<float, KdLeaf::kPoints>& distances_sq);

  // In ascending order; fewer than count where fewer were added.
  std::span<const Rank> sorted();

 private:
  void keep_first();

  std::size_t count_, enough_;  // so many are sorted
  std::array<Rank, kFewRanks> few_;
  std::vector<Rank> many_;  // used instead where count asks for more
  Rank* ranks_;
  std::size_t num_ranks_ = 0;
  Rank limit_ = kMissing;
};

}  // namespace augicp
