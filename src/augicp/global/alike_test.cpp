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

std::uint32_t plainly_most_alike(const Descriptor& query, const KeyPoints& others) {
  std::vector<std::pair<float, std::uint32_t>> ranked;
  for (std::uint32_t j = 0; j < others.size(); ++j)
    ranked.emplace_back(-std::inner_product(query.begin(), query.end(), others.descriptors[j].begin(), 0.0f), j);
  return std::min_element(ranked.begin(), ranked.end())->second;
}

std::set<std::pair<std::uint32_t, std::uint32_t>> plain_pairs(const KeyPoints& source, const KeyPoints& target) {
  std::set<std::pair<std::uint32_t, std::uint32_t>> pairs;
  for (std::uint32_t i = 0; i < source.size(); ++i) pairs.emplace(i, plainly_most_alike(source.descriptors[i], target));
  for (std::uint32_t j = 0; j < target.size(); ++j) pairs.emplace(plainly_most_alike(target.descriptors[j], source), j);
  return pairs;
}

std::vector<std::pair<std::uint32_t, std::uint32_t>> found_pairs(const KeyPoints& source, const KeyPoints& target,
                                                                 int num_threads) {
  std::vector<std::pair<std::uint32_t, std::uint32_t>> found;
  for (const Correspondence& pair : alike_pairs(source, target, num_threads))
    found.emplace_back(pair.source, pair.target);
  return found;
}

// Sizes around the borders of blocks, rows and columns.
TEST(AlikePairs, EqualAPlainLoop) {
  for (const auto& [num_source, num_target] : {std::pair{1, 1}, {3, 70}, {64, 32}, {65, 33}, {130, 95}})
    for (const int num_threads : {1, 4}) {
      const KeyPoints source = random_keys(num_source, 1), target = random_keys(num_target, 2);
      EXPECT_THAT(found_pairs(source, target, num_threads), ::testing::ElementsAreArray(plain_pairs(source, target)))
          << num_source << " " << num_target;
    }
}

// Of equal ones the first, on either side and across blocks.
TEST(AlikePairs, OfEqualPointsAreTheFirst) {
  KeyPoints source = random_keys(100, 1), target = random_keys(90, 2);
  source.descriptors[70] = source.descriptors[7];
  target.descriptors[80] = target.descriptors[8];
  for (const int num_threads : {1, 4})
    EXPECT_THAT(found_pairs(source, target, num_threads), ::testing::ElementsAreArray(plain_pairs(source, target)));
}

TEST(AlikePairs, OfNoPointsAreNone) {
  EXPECT_TRUE(alike_pairs({}, random_keys(5, 1), 1).empty());
  EXPECT_TRUE(alike_pairs(random_keys(5, 1), {}, 1).empty());
}

}  // namespace
}  // namespace augicp
