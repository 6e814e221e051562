// SPDX-License-Identifier: MIT
#include "augicp/core/parallel.h"
#include "augicp/match/matcher.h"
#include "augicp/match/pair_filter.h"
#include "augicp/sensor/projection.h"

namespace augicp {

ProjectiveMatcher::ProjectiveMatcher(const Cloud& target, const IndexImage& index, const Pinhole& camera)
    : target_(target), index_(index), camera_(camera) {
  camera.check();
}

std::vector<Correspondence> ProjectiveMatcher::match(const Cloud& source, const Rigid3& target_from_source,
                                                     const Gates& gates, int num_threads) const {
  gates.check();
  const PairFilter filter(source, target_, target_from_source, gates);
  const IndexImage seen = project(source, target_from_source, camera_, index_.width, index_.height, num_threads);
  // Every block of pixels writes to its own part, which is then moved up to those before.
  std::vector<Correspondence> pairs(seen.index.size());
  std::vector<std::size_t> num_found((pairs.size() + kBlockSize - 1) / kBlockSize);
  for_each_block(pairs.size(), num_threads, [&](std::size_t begin, std::size_t end) {
    std::size_t next = begin;
    for (std::size_t pixel = begin; pixel < end; ++pixel) {
      if (seen.index[pixel] == IndexImage::kNone || index_.index[pixel] == IndexImage::kNone) continue;
      const auto j = static_cast<std::uint32_t>(seen.index[pixel]), i = static_cast<std::uint32_t>(index_.index[pixel]);
      if (filter.passes(j, filter.moved(j), i)) pairs[next++] = {j, i};
    }
    num_found[begin / kBlockSize] = next - begin;
  });
  std::size_t num_pairs = 0;
  for (std::size_t block = 0; block < num_found.size(); ++block)
    for (std::size_t k = 0; k < num_found[block]; ++k) pairs[num_pairs++] = pairs[block * kBlockSize + k];
  pairs.resize(num_pairs);
  return pairs;
}

}  // namespace augicp
