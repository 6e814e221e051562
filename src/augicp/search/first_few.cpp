// SPDX-License-Identifier: MIT
#include "augicp/search/first_few.h"

#include <algorithm>
#include <cstring>

#include "augicp/core/vectorized.h"

namespace augicp {
namespace {

constexpr std::size_t kLanes = 8;

// For each rank, the number of ranks below it. REQUIRES: count is a multiple of kLanes.
AUGICP_VECTORIZED void count_below(const Rank* __restrict ranks, std::size_t count, Rank* __restrict num_below) {
  using FourRanks [[gnu::vector_size(32)]] = Rank;
  for (std::size_t i = 0; i < count; i += kLanes) {
    FourRanks first, second, below_first{}, below_second{};
    std::memcpy(&first, ranks + i, sizeof first);
    std::memcpy(&second, ranks + i + kLanes / 2, sizeof second);
    for (std::size_t k = 0; k < count; ++k) {  // true is -1
      below_first -= ranks[k] < first;
      below_second -= ranks[k] < second;
    }
    std::memcpy(num_below + i, &below_first, sizeof first);
    std::memcpy(num_below + i + kLanes / 2, &below_second, sizeof second);
  }
}

// Moves each rank to its sorted position.
void sort_few(Rank* ranks, std::size_t count) {
  std::array<Rank, kFewRanks> padded, num_below;
  std::fill(std::copy(ranks, ranks + count, padded.begin()), padded.end(), kMissing);
  count_below(padded.data(), (count + kLanes - 1) / kLanes * kLanes, num_below.data());
  for (std::size_t k = 0; k < count; ++k) ranks[num_below[k]] = padded[k];
}

}  // namespace

FirstFew::FirstFew(std::size_t count, Rank limit)
    : count_(count), enough_(count + count / 2 + KdLeaf::kPoints), limit_(limit) {
  const std::size_t room = enough_ + KdLeaf::kPoints;
  if (room > kFewRanks) many_.resize(room);
  ranks_ = room > kFewRanks ? many_.data() : few_.data();
}

void FirstFew::add(const KdLeaf& leaf, const std::array<float, KdLeaf::kPoints>& distances_sq) {
  const Rank limit = limit_;
  std::size_t end = num_ranks_;
  for (std::size_t k = 0; k < KdLeaf::kPoints; ++k) {
    const Rank rank = rank_of(distances_sq[k], leaf.index[k]);
    ranks_[end] = rank;
    end += rank < limit ? 1 : 0;
  }
  num_ranks_ = end;
  if (num_ranks_ >= enough_) keep_first();
}

std::span<const Rank> FirstFew::sorted() {
  keep_first();
  return {ranks_, num_ranks_};
}

void FirstFew::keep_first() {
  if (num_ranks_ <= kFewRanks)
    sort_few(ranks_, num_ranks_);
  else
    std::sort(ranks_, ranks_ + num_ranks_);
  if (num_ranks_ < count_) return;
  num_ranks_ = count_;
  limit_ = ranks_[count_ - 1];
}

}  // namespace augicp
