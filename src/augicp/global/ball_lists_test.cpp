// SPDX-License-Identifier: MIT
#include "augicp/global/ball_lists.h"

#include <gmock/gmock.h>

#include <algorithm>

#include "augicp/testing/random_clouds.h"

namespace augicp {
namespace {

std::vector<std::uint32_t> plainly_within(const Vec3f& query, const std::vector<Vec3f>& support, float radius) {
  std::vector<std::uint32_t> found;
  for (std::uint32_t i = 0; i < support.size(); ++i)
    if ((support[i] - query).squaredNorm() <= radius * radius) found.push_back(i);
  return found;
}

TEST(BallLists, EqualAPlainLoop) {
  const auto queries = testing::random_points(600, 1.0, 1).points, support = testing::random_points(700, 1.1, 2).points;
  for (const double radius : {0.05, 0.3, 1.0, 5.0})
    for (const int num_threads : {1, 3}) {
      const BallLists lists(queries, support, radius, num_threads);
      for (std::size_t i = 0; i < queries.size(); ++i) {
        const auto around = lists.around(i);
        std::vector<std::uint32_t> found(around.begin(), around.end());
        std::sort(found.begin(), found.end());
        ASSERT_EQ(found, plainly_within(queries[i], support, static_cast<float>(radius))) << radius << " " << i;
      }
    }
}

TEST(BallLists, WithoutSupportAreEmpty) {
  const auto queries = testing::random_points(3, 1.0, 1).points;
  const BallLists lists(queries, {}, 1.0, 1);
  for (std::size_t i = 0; i < queries.size(); ++i) EXPECT_TRUE(lists.around(i).empty());
  const BallLists none({}, queries, 1.0, 1);
}

}  // namespace
}  // namespace augicp
