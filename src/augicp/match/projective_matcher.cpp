// SPDX-License-Identifier: MIT
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
  const IndexImage seen =
      project(source, target_from_source, camera_, index_.width, index_.height, num_threads);
  std::vector<Correspondence> pairs;
  pairs.reserve(source.size());
  for (std::size_t pixel = 0; pixel < seen.index.size(); ++pixel) {
    if (seen.index[pixel] == IndexImage::kNone || index_.index[pixel] == IndexImage::kNone) continue;
    const auto j = static_cast<std::uint32_t>(seen.index[pixel]), i = static_cast<std::uint32_t>(index_.index[pixel]);
    if (filter.passes(j, filter.moved(j), i)) pairs.push_back({j, i});
  }
  return pairs;
}

}  // namespace augicp
