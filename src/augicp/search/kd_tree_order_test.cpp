// SPDX-License-Identifier: MIT
// The answers of a tree to the last bit: distances and, of points equally near, the lower index.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "augicp/search/kd_tree.h"
#include "augicp/testing/random_clouds.h"

namespace augicp {
namespace {

using testing::random_points;

constexpr float kAnyDistance = std::numeric_limits<float>::infinity();

// All points, nearest first: the slow way to every query.
std::vector<Neighbour> all_in_order(const Cloud& cloud, const Vec3f& query) {
  std::vector<Neighbour> all;
  for (std::uint32_t i = 0; i < cloud.size(); ++i) {
    const Vec3f apart = cloud.points[i] - query;
    all.push_back({i, apart.x() * apart.x() + apart.y() * apart.y() + apart.z() * apart.z()});
  }
  std::stable_sort(all.begin(), all.end(),
                   [](const Neighbour& a, const Neighbour& b) { return a.distance_sq < b.distance_sq; });
  return all;
}

struct OrderCase {
  std::string name;
  Cloud cloud;
};

Cloud scaled_points(Cloud cloud, float scale) {
  for (Vec3f& point : cloud.points) point *= scale;
  return cloud;
}

Cloud with(Cloud cloud, const std::vector<Vec3f>& points) {
  cloud.points.insert(cloud.points.end(), points.begin(), points.end());
  return cloud;
}

Cloud square_grid(int side) {
  Cloud cloud;
  for (int i = 0; i < side * side * side; ++i)
    cloud.points.emplace_back(static_cast<float>(i % side), static_cast<float>(i / side % side),
                              static_cast<float>(i / (side * side)));
  return cloud;
}

// Each place several times, far from each other in the cloud.
Cloud repeated(const Cloud& cloud, int times) {
  Cloud all;
  for (int k = 0; k < times; ++k) all.points.insert(all.points.end(), cloud.points.begin(), cloud.points.end());
  return all;
}

Cloud on_a_line(int count) {
  Cloud cloud;
  for (int i = 0; i < count; ++i)
    cloud.points.push_back(static_cast<float>(i * 7919 % count) * Vec3f(0.01f, 0.0f, -0.02f));
  return cloud;
}

// Many kinds, and numbers of points around those at which leaves and nodes are full.
std::vector<OrderCase> clouds() {
  std::vector<OrderCase> cases{
      {"square_grid", square_grid(9)},
      {"every place five times", repeated(random_points(150, 1.0, 2), 5)},
      {"a heap among others", with(random_points(300, 1.0, 3), std::vector<Vec3f>(400, Vec3f(0.2f, 0.3f, 0.4f)))},
      {"a line", on_a_line(777)},
      {"far outliers", with(random_points(500, 1.0, 4), {{1e18f, -1e18f, 0.0f}, {-1e18f, 3.0f, 1e18f}})},
      {"huge", scaled_points(random_points(500, 1.0, 5), 1e18f)},
      {"squares overflow", scaled_points(random_points(500, 1.0, 6), 1e30f)},
      {"tiny", scaled_points(random_points(500, 1.0, 7), 1e-30f)}};
  for (int count : {1, 2, 3, 15, 16, 17, 31, 32, 33, 63, 64, 65, 255, 257, 1023})
    cases.push_back({std::to_string(count) + " points", random_points(static_cast<std::size_t>(count), 1.0, 8)});
  return cases;
}

std::vector<Vec3f> queries_for(const Cloud& cloud) {
  std::vector<Vec3f> queries = random_points(20, 1.5, 9).points;
  for (std::size_t k = 0; k < 10; ++k) {
    const Vec3f& point = cloud.points[k * cloud.size() / 10];
    queries.insert(queries.end(), {point, point + Vec3f(0.5f, 0.5f, 0.0f), 2.0f * point});
  }
  return queries;
}

TEST(KdTreeOrder, NearestFewAreThoseOfAllInOrder) {
  for (const auto& [name, cloud] : clouds()) {
    const KdTree tree(cloud);
    for (const Vec3f& query : queries_for(cloud)) {
      const std::vector<Neighbour> all = all_in_order(cloud, query);
      for (std::size_t count : {1, 2, 10, 20, 21, 22, 64, 100, 5000}) {
        const std::vector<Neighbour> found = tree.nearest_k(query, count);
        ASSERT_EQ(found.size(), std::min(count, cloud.size())) << name;
        for (std::size_t k = 0; k < found.size(); ++k) {
          ASSERT_EQ(found[k].index, all[k].index) << name << ", " << k << " of " << count;
          ASSERT_EQ(found[k].distance_sq, all[k].distance_sq) << name;
        }
      }
    }
  }
}

// Whatever place is given as likely, and of points at the gate itself none.
TEST(KdTreeOrder, NearestIsTheFirstOfAll) {
  for (const auto& [name, cloud] : clouds()) {
    const KdTree tree(cloud);
    for (const Vec3f& query : queries_for(cloud)) {
      const Neighbour first = all_in_order(cloud, query).front();
      const float above = std::nextafter(first.distance_sq, kAnyDistance);
      for (std::size_t k = 0; k < 6; ++k) {
        const auto likely = static_cast<std::uint32_t>(k * cloud.size() / 5);  // also none
        EXPECT_FALSE(tree.nearest(query, first.distance_sq, likely)) << name;
        if (!(first.distance_sq < kAnyDistance)) continue;
        for (float gate : {above, kAnyDistance}) {
          const auto found = tree.nearest(query, gate, likely);
          ASSERT_TRUE(found) << name;
          EXPECT_EQ(found->index, first.index) << name;
          EXPECT_EQ(found->distance_sq, first.distance_sq) << name;
        }
      }
    }
  }
}

TEST(KdTreeOrder, QueriesThatAreNotFiniteFindNothing) {
  const Cloud cloud = random_points(100, 1.0, 10);
  const KdTree tree(cloud);
  for (float odd : {std::nanf(""), -std::nanf(""), kAnyDistance, -kAnyDistance}) {
    EXPECT_FALSE(tree.nearest({0.0f, odd, 0.0f}, kAnyDistance, 3));
    EXPECT_TRUE(tree.nearest_k({0.0f, 0.0f, odd}, 5).empty());
  }
  EXPECT_FALSE(tree.nearest(cloud.points[0], std::nanf("")));
  EXPECT_FALSE(tree.nearest(cloud.points[0], -1.0f));
}

// robustness 10: many points in one place, in two, and in one among others. If all of them were visited, these queries
// would take hours.
TEST(KdTreeOrder, HeapsOfEqualPointsCostNoMoreThanOthers) {
  constexpr std::size_t kCount = 100000;
  const Vec3f place(0.1f, 0.2f, 0.3f), other(0.1f, 0.2f, 0.4f);
  Cloud heap, mixed = random_points(kCount, 1.0, 11);
  heap.points.assign(kCount, place);
  for (std::size_t i = 0; i < kCount; ++i) mixed.points.push_back(i % 2 == 0 ? place : other);
  for (const Cloud& cloud : {heap, mixed}) {
    const KdTree tree(cloud);
    const auto first = static_cast<std::uint32_t>(cloud.size() - kCount);
    for (std::size_t i = 0; i < kCount; ++i) {
      ASSERT_EQ(tree.nearest(place, kAnyDistance)->index, first);
      ASSERT_EQ(tree.nearest_k(place, 10).front().index, first);
    }
  }
}

}  // namespace
}  // namespace augicp
