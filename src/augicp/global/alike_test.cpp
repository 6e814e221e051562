// SPDX-License-Identifier: MIT
#include "augicp/global/alike.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <numeric>
#include <set>

#include "augicp/global/key_testing.h"

namespace augicp {
namespace {

KeyPoints random_keys(std::size_t count, unsigned seed) {
  std::mt19937 generator(seed);
  KeyPoints keys;
  keys.points.resize(count);
  keys.normals.resize(count);
  keys.descriptors.resize(count);
  for (Descriptor& descriptor : keys.descriptors)
    for (float& number : descriptor) number = static_cast<float>(testing::uniform(generator, 0.0, 1.0));
  return keys;
}

std::vector<std::uint32_t> plainly_most_alike(const Descriptor& query, const KeyPoints& others, std::size_t count) {
  std::vector<std::pair<float, std::uint32_t>> ranked;
  for (std::uint32_t j = 0; j < others.size(); ++j)
    ranked.emplace_back(-std::inner_product(query.begin(), query.end(), others.descriptors[j].begin(), 0.0f), j);
  std::sort(ranked.begin(), ranked.end());
  std::vector<std::uint32_t> best;
  for (std::size_t k = 0; k < std::min(count, ranked.size()); ++k) best.push_back(ranked[k].second);
  return best;
}

// Sizes around the borders of blocks, rows and columns.
TEST(AlikePairs, EqualAPlainLoop) {
  for (const auto& [num_source, num_target] : {std::pair{1, 1}, {3, 70}, {64, 32}, {65, 33}, {130, 95}})
    for (const std::size_t count : {1u, 3u}) {
      const KeyPoints source = random_keys(num_source, 1), target = random_keys(num_target, 2);
      std::set<std::pair<std::uint32_t, std::uint32_t>> expected;
      for (std::uint32_t i = 0; i < source.size(); ++i)
        for (const std::uint32_t j : plainly_most_alike(source.descriptors[i], target, count)) expected.emplace(i, j);
      for (std::uint32_t j = 0; j < target.size(); ++j)
        for (const std::uint32_t i : plainly_most_alike(target.descriptors[j], source, count)) expected.emplace(i, j);
      for (const int num_threads : {1, 4}) {
        std::vector<std::pair<std::uint32_t, std::uint32_t>> found;
        for (const Correspondence& pair : alike_pairs(source, target, count, num_threads))
          found.emplace_back(pair.source, pair.target);
        EXPECT_THAT(found, ::testing::ElementsAreArray(expected)) << num_source << " " << num_target;
      }
    }
}

TEST(AlikePairs, OfNoPointsAreNone) {
  EXPECT_TRUE(alike_pairs({}, random_keys(5, 1), 1, 1).empty());
  EXPECT_TRUE(alike_pairs(random_keys(5, 1), {}, 1, 1).empty());
}

}  // namespace
}  // namespace augicp
