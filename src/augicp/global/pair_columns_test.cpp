// SPDX-License-Identifier: MIT
#include "augicp/global/pair_columns.h"

#include <gmock/gmock.h>

#include "augicp/global/key_testing.h"

namespace augicp {
namespace {

TEST(PairColumns, EqualAPlainLoop) {
  constexpr double kDistance = 0.3, kCosine = 0.5;
  for (const std::size_t num_false : {0u, 1u, 200u}) {
    const KnownKeys keys = known_keys(31, num_false, 7);
    const PairColumns columns(keys.source, keys.target, keys.pairs);
    const Rigid3f moves(keys.target_from_source);
    std::vector<std::uint32_t> expected;
    for (std::uint32_t k = 0; k < keys.pairs.size(); ++k) {
      const auto [i, j] = keys.pairs[k];
      const float distance = (moves * keys.source.points[i] - keys.target.points[j]).norm();
      const float cosine = (moves.rotation * keys.source.normals[i]).dot(keys.target.normals[j]);
      if (distance <= kDistance && cosine >= kCosine) expected.push_back(k);
    }
    EXPECT_GE(expected.size(), 31u);
    EXPECT_EQ(columns.supporting(keys.target_from_source, kDistance, kCosine), expected);
  }
}

TEST(PairColumns, NoPairSupportsAnything) { EXPECT_TRUE(PairColumns({}, {}, {}).supporting({}, 1.0, -1.0).empty()); }

}  // namespace
}  // namespace augicp
