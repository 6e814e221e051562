// SPDX-License-Identifier: MIT
#include "augicp/global/consistency.h"

#include <gmock/gmock.h>

#include <cmath>

#include "augicp/global/key_testing.h"

namespace augicp {
namespace {

constexpr ConsistencyLimits kLimits{0.05, 0.2, 0.3};

bool are_plainly_consistent(const KnownKeys& keys, const Correspondence& a, const Correspondence& b) {
  struct Invariants {
    float distance, first, second, between;
  };
  const auto of = [](const KeyPoints& points, std::uint32_t i, std::uint32_t j) {
    const Vec3f offset = points.points[j] - points.points[i];
    const float distance = offset.norm();
    return Invariants{distance, points.normals[i].dot(offset) / distance, points.normals[j].dot(offset) / distance,
                      points.normals[i].dot(points.normals[j])};
  };
  const Invariants s = of(keys.source, a.source, b.source), t = of(keys.target, a.target, b.target);
  return s.distance >= kLimits.min_distance && t.distance >= kLimits.min_distance &&
         std::abs(s.distance - t.distance) <= kLimits.distance && std::abs(s.first - t.first) <= kLimits.cosine &&
         std::abs(s.second - t.second) <= kLimits.cosine && std::abs(s.between - t.between) <= kLimits.cosine;
}

TEST(ConsistencyGraph, EqualsAPlainLoop) {
  for (const std::size_t num_false : {0u, 34u, 98u, 99u}) {  // 30, 64, 128 and 129 pairs
    const KnownKeys keys = known_keys(30, num_false, 4);
    for (const int num_threads : {1, 3}) {
      const ConsistencyGraph graph(keys.source, keys.target, keys.pairs, kLimits, num_threads);
      ASSERT_EQ(graph.size(), keys.pairs.size());
      for (std::size_t a = 0; a < graph.size(); ++a) {
        std::vector<std::uint32_t> expected;
        for (std::uint32_t b = 0; b < graph.size(); ++b)
          if (a != b && are_plainly_consistent(keys, keys.pairs[a], keys.pairs[b])) expected.push_back(b);
        EXPECT_EQ(graph.consistent_with(a), expected) << num_false;
      }
    }
  }
}

TEST(ConsistencyGraph, TruePairsAreConsistentUnlessNear) {
  const KnownKeys keys = known_keys(60, 0, 5);
  const ConsistencyGraph graph(keys.source, keys.target, keys.pairs, kLimits, 1);
  for (std::size_t a = 0; a < 60; ++a)
    for (std::size_t b = 0; b < 60; ++b) {
      const bool is_near = (keys.source.points[a] - keys.source.points[b]).norm() < kLimits.min_distance;
      EXPECT_EQ(graph.are_consistent(a, b), !is_near);
    }
}

TEST(ConsistencyGraph, CommonOnesAreCounted) {
  const KnownKeys keys = known_keys(60, 50, 6);
  const ConsistencyGraph graph(keys.source, keys.target, keys.pairs, kLimits, 1);
  for (std::size_t a = 0; a < graph.size(); ++a)
    for (std::size_t b = 0; b < graph.size(); ++b) {
      int count = 0;
      for (std::size_t c = 0; c < graph.size(); ++c) count += graph.are_consistent(a, c) && graph.are_consistent(b, c);
      ASSERT_EQ(graph.num_common(a, b), count);
    }
}

}  // namespace
}  // namespace augicp
