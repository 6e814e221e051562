// SPDX-License-Identifier: MIT
#include "augicp/core/parallel.h"
#include "augicp/match/agreement_count.h"
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
    std::uint32_t likely = 0;  // what the point before found: neighbours in memory mostly are neighbours in space
    for (auto j = static_cast<std::uint32_t>(begin); j < end; ++j) {
      const Vec3f moved = filter.moved(j);
      const auto found = tree_.nearest(moved, filter.max_distance_sq(), likely);
      if (found) likely = found->index;
      if (found && filter.passes(j, moved, found->index)) of_block[begin / kBlockSize].push_back({j, found->index});
    }
  });
  return joined(of_block);
}

Agreement NearestMatcher::agreement(const Cloud& source, const Rigid3& target_from_source,
                                    const AgreementTolerance& tolerance, int num_threads) const {
  tolerance.check();
  const SurfaceTest on_surface(source, target_, target_from_source, tolerance.min_cosine);
  const auto limit = static_cast<float>(tolerance.distance);
  const float reach = kNearPerTolerance * limit;
  return blocked_sum<Agreement>(source.size(), num_threads, [&](std::size_t begin, std::size_t end) {
    Agreement count;
    std::uint32_t likely = 0;
    for (std::size_t j = begin; j < end; ++j) {
      const Vec3f moved = on_surface.moved(j);
      const auto found = tree_.nearest(moved, reach * reach, likely);
      if (found) likely = found->index;
      ++(!found ? count.unseen : on_surface.agrees(j, moved, found->index, limit) ? count.agree : count.differ);
    }
    return count;
  });
}

}  // namespace augicp
