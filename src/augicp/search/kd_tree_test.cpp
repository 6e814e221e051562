// SPDX-License-Identifier: MIT
#include "augicp/search/kd_tree.h"

#include <gtest/gtest.h>
#include <pthread.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <set>
#include <string>

#include "augicp/testing/random_clouds.h"

namespace augicp {
namespace {

using testing::random_points;

constexpr float kFar = std::numeric_limits<float>::infinity();

float distance_sq(const Vec3f& a, const Vec3f& b) { return (a - b).squaredNorm(); }

// All squared distances, smallest first: the slow way to every query. Ties make indices ambiguous, distances never.
std::vector<float> sorted_distances_sq(const Cloud& cloud, const Vec3f& query) {
  std::vector<float> all;
  for (const Vec3f& point : cloud.points) all.push_back(distance_sq(point, query));
  std::sort(all.begin(), all.end());
  return all;
}

struct TreeCase {
  std::string name;
  Cloud cloud;
};

Cloud equal_points(std::size_t count) {
  Cloud cloud;
  cloud.points.assign(count, Vec3f(0.1f, 0.2f, 0.3f));
  return cloud;
}

Cloud points_on_a_line() {
  Cloud cloud;
  for (int i = 0; i < 500; ++i) cloud.points.push_back(0.01f * static_cast<float>(i - 250) * Vec3f(1.0f, -2.0f, 0.5f));
  return cloud;
}

// Whole coordinates: most queries have several nearest points.
Cloud grid() {
  Cloud cloud;
  for (int i = 0; i < 512; ++i)
    cloud.points.emplace_back(static_cast<float>(i % 8 - 4), static_cast<float>(i / 8 % 8 - 4),
                              static_cast<float>(i / 64 - 4));
  return cloud;
}

Cloud with_outlier() {
  Cloud cloud = random_points(500, 1.0, 3);
  cloud.points.emplace_back(1e6f, 0.0f, 0.0f);
  return cloud;
}

std::vector<TreeCase> awkward_clouds() {
  return {{"random", random_points(2000, 1.0, 1)},
          {"empty", {}},
          {"one point", random_points(1, 1.0, 2)},
          {"equal points", equal_points(5000)},
          {"ties", grid()},
          {"a line", points_on_a_line()},
          {"an outlier", with_outlier()},
          {"two points", random_points(2, 1.0, 4)}};
}

std::vector<Vec3f> queries() {
  std::vector<Vec3f> queries = random_points(30, 1.5, 5).points;
  queries.insert(queries.end(), {{0.0f, 0.0f, 0.0f}, {0.5f, 0.5f, 0.5f}, {0.1f, 0.2f, 0.3f}, {9e5f, 10.0f, 0.0f}});
  return queries;
}

// A tree a thousand times deeper than it should be has no room in this.
template <typename Work>
void run_with_small_stack(Work work) {
  constexpr std::size_t kStackBytes = 1 << 20;
  pthread_attr_t attributes;
  pthread_t thread;
  ASSERT_EQ(pthread_attr_init(&attributes), 0);
  ASSERT_EQ(pthread_attr_setstacksize(&attributes, kStackBytes), 0);
  const auto start = [](void* argument) -> void* {
    (*static_cast<Work*>(argument))();
    return nullptr;
  };
  ASSERT_EQ(pthread_create(&thread, &attributes, start, &work), 0);
  pthread_join(thread, nullptr);
  pthread_attr_destroy(&attributes);
}

TEST(KdTree, NearestIsTheBruteForceOne) {
  for (const auto& [name, cloud] : awkward_clouds()) {
    const KdTree tree(cloud);
    for (const Vec3f& query : queries()) {
      const auto found = tree.nearest(query, kFar);
      ASSERT_EQ(found.has_value(), !cloud.empty()) << name;
      if (!found) continue;
      EXPECT_FLOAT_EQ(found->distance_sq, sorted_distances_sq(cloud, query).front()) << name;
      EXPECT_FLOAT_EQ(found->distance_sq, distance_sq(cloud.points[found->index], query)) << name;
    }
  }
}

TEST(KdTree, NearestFewAreTheBruteForceOnesInOrder) {
  for (const auto& [name, cloud] : awkward_clouds()) {
    const KdTree tree(cloud);
    for (const Vec3f& query : queries()) {
      const std::vector<float> expected = sorted_distances_sq(cloud, query);
      for (std::size_t count : {0, 1, 7, 6000}) {
        const std::vector<Neighbour> found = tree.nearest_k(query, count);
        ASSERT_EQ(found.size(), std::min(count, cloud.size())) << name;
        std::set<std::uint32_t> indices;
        for (std::size_t k = 0; k < found.size(); ++k) {
          EXPECT_FLOAT_EQ(found[k].distance_sq, expected[k]) << name;
          EXPECT_FLOAT_EQ(found[k].distance_sq, distance_sq(cloud.points[found[k].index], query)) << name;
          indices.insert(found[k].index);
        }
        EXPECT_EQ(indices.size(), found.size()) << name << ": a point was found twice";
      }
    }
  }
}

// Whatever is taken for likely, and under gates that hide one of them or all.
TEST(KdTree, NearestFewBelowAGateAreTheFirstOfMany) {
  for (const auto& [name, cloud] : awkward_clouds()) {
    const KdTree tree(cloud);
    std::array<std::uint32_t, kFew> likely{7, 8, 9};
    for (const Vec3f& query : queries()) {
      const std::vector<Neighbour> expected = tree.nearest_k(query, kFew);
      for (float gate : {kFar, 0.1f, 1e-3f}) {
        const NearestFew found = tree.nearest_few(query, gate, likely);
        for (std::size_t k = 0; k < kFew; ++k) {
          ASSERT_EQ(found[k].has_value(), k < expected.size() && expected[k].distance_sq < gate) << name << gate;
          if (!found[k]) continue;
          EXPECT_EQ(found[k]->index, expected[k].index) << name << gate;
          EXPECT_EQ(found[k]->distance_sq, expected[k].distance_sq) << name << gate;
        }
        for (std::size_t k = 0; k < kFew && found.back(); ++k) likely[k] = found[k]->index;
      }
    }
  }
}

TEST(KdTree, ManyBelowAGateAreTheFirstOfAll) {
  for (const auto& [name, cloud] : awkward_clouds()) {
    const KdTree tree(cloud);
    for (const Vec3f& query : queries()) {
      const std::vector<Neighbour> expected = tree.nearest_k(query, 20);
      for (float gate : {kFar, 0.1f, 1e-3f, 0.0f}) {
        const std::vector<Neighbour> found = tree.nearest_k(query, 20, gate);
        const auto is_below = [=](const Neighbour& one) { return one.distance_sq < gate; };
        ASSERT_EQ(found.size(), static_cast<std::size_t>(std::count_if(expected.begin(), expected.end(), is_below)))
            << name << gate;
        for (std::size_t k = 0; k < found.size(); ++k) EXPECT_EQ(found[k].index, expected[k].index) << name << gate;
      }
    }
  }
}

TEST(KdTree, AllWithinADistanceAreTheBruteForceOnes) {
  for (const auto& [name, cloud] : awkward_clouds()) {
    const KdTree tree(cloud);
    for (const Vec3f& query : queries())
      for (float limit : {kFar, 0.1f, 1e-3f, 0.0f}) {
        std::vector<std::uint32_t> expected, found;
        for (std::uint32_t i = 0; i < cloud.size(); ++i)
          if (tree.distance_sq(query, i) <= limit) expected.push_back(i);
        tree.append_within(query, limit, found);
        std::sort(found.begin(), found.end());
        EXPECT_EQ(found, expected) << name << limit;
      }
  }
}

TEST(KdTree, GateOfNearestIsStrict) {
  Cloud cloud;
  cloud.points = {{2.0f, 0.0f, 0.0f}};
  const KdTree tree(cloud);
  EXPECT_FALSE(tree.nearest(Vec3f::Zero(), 4.0f));
  EXPECT_TRUE(tree.nearest(Vec3f::Zero(), std::nextafter(4.0f, 5.0f)));
  EXPECT_FALSE(tree.nearest(cloud.points[0], 0.0f));
}

TEST(KdTree, GateHidesNothingThatIsNearer) {
  const Cloud cloud = random_points(2000, 1.0, 6);
  const KdTree tree(cloud);
  for (const Vec3f& query : queries()) {
    const float nearest = sorted_distances_sq(cloud, query).front();
    for (float factor : {0.5f, 0.99f, 1.01f, 2.0f}) {
      const auto found = tree.nearest(query, factor * nearest);
      ASSERT_EQ(found.has_value(), factor > 1.0f);
      if (!found) continue;
      EXPECT_FLOAT_EQ(found->distance_sq, nearest);
    }
  }
}

TEST(KdTree, QueryThatIsNotANumberFindsNothing) {
  const Cloud cloud = random_points(100, 1.0, 7);
  const KdTree tree(cloud);
  EXPECT_FALSE(tree.nearest(Vec3f::Constant(std::nanf("")), kFar));
}

// A tree that splits off one of many equal points at a time would be as deep as there are points.
TEST(KdTree, ManyEqualPointsMakeNoDeepTree) {
  Cloud cloud = equal_points(100000);
  cloud.points.emplace_back(5.0f, 0.0f, 0.0f);
  const KdTree tree(cloud);
  EXPECT_EQ(tree.nearest({4.0f, 0.0f, 0.0f}, kFar)->index, 100000u);
  EXPECT_EQ(tree.nearest_k(cloud.points[0], 10).back().distance_sq, 0.0f);
}

// robustness 10: without a bound on the branches that are entered, these queries would look at 10^10 points.
TEST(KdTree, ManyEqualPointsCostNoMoreThanOthers) {
  const Cloud cloud = equal_points(100000);
  const KdTree tree(cloud);
  for (int i = 0; i < 100000; ++i) {
    const auto shift = static_cast<float>(i % 7) * 0.1f;  // also zero
    const Vec3f query = cloud.points.front() + Vec3f(shift, 3.0f * shift, -0.7f * shift);
    ASSERT_FLOAT_EQ(tree.nearest(query, kFar)->distance_sq, distance_sq(cloud.points.front(), query));
  }
}

// Half of the points nearer to zero than the other half, and so on down to the smallest numbers: a tree that splits in
// the middle becomes as deep as floats have exponents. In a thread with a small stack, which a deeper one would
// overflow.
TEST(KdTree, PointsThatCrowdTogetherMakeNoDeepTree) {
  Cloud cloud = equal_points(1000);
  for (int exponent = -149; exponent < 59; ++exponent)
    for (int i = 0; i < 500; ++i) {
      const float x = std::ldexp(1.0f + 0.001f * static_cast<float>(i), exponent);
      cloud.points.emplace_back(i % 3 == 0 ? x : 0.0f, i % 3 == 1 ? -x : 0.0f, i % 3 == 2 ? x : 0.0f);
    }
  run_with_small_stack([&] {
    const KdTree tree(cloud);
    EXPECT_EQ(tree.nearest(cloud.points.front(), kFar)->distance_sq, 0.0f);
  });
}

TEST(KdTree, StillAnswersWhenMoved) {
  const Cloud cloud = random_points(100, 1.0, 8);
  KdTree tree(cloud);
  const KdTree moved = std::move(tree);
  EXPECT_FLOAT_EQ(moved.nearest(cloud.points[42], kFar)->distance_sq, 0.0f);
}

}  // namespace
}  // namespace augicp
