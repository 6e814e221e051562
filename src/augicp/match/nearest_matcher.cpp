// SPDX-License-Identifier: MIT
#include "augicp/core/parallel.h"
#include "augicp/match/matcher.h"
#include "augicp/match/pair_filter.h"

namespace augicp {

NearestMatcher::NearestMatcher(const Cloud& target) : target_(target), tree_(target) {}

std::vector<Correspondence> NearestMatcher::match(const Cloud& source, const Rigid3& target_from_source,
                                                  const Gates& gates, int num_threads) const {
  gates.check();
  const PairFilter filter(source, target_, target_from_source, gates);
  std::vector<std::vector<Correspondence>> of_block((source.size() + kBlockSize - 1) / kBlockSize);
  for_each_block(source.size(), num_threads, [&](std::size_t begin, std::size_t end) {
    for (auto j = static_cast<std::uint32_t>(begin); j < end; ++j) {
      const Vec3f moved = filter.moved(j);
      const auto found = tree_.nearest(moved, filter.max_distance_sq());
      if (found && filter.passes(j, moved, found->index)) of_block[begin / kBlockSize].push_back({j, found->index});
    }
  });
  std::vector<Correspondence> pairs;
  pairs.reserve(source.size());
  for (const auto& block : of_block) pairs.insert(pairs.end(), block.begin(), block.end());
  return pairs;
}

}  // namespace augicp
