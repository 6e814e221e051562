// SPDX-License-Identifier: MIT
#include "augicp/search/nearest_memory.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <string>

#include "augicp/testing/poses.h"
#include "augicp/testing/random_clouds.h"

namespace augicp {
namespace {

using testing::random_points;

constexpr float kInfinity = std::numeric_limits<float>::infinity();
constexpr std::size_t kNumQueries = 200;

struct MemoryCase {
  std::string name;
  Cloud cloud;
  double extent;  // of the queries
};

Cloud remembered_grid() {
  Cloud cloud;
  for (int i = 0; i < 512; ++i)
    cloud.points.emplace_back(static_cast<float>(i % 8), static_cast<float>(i / 8 % 8), static_cast<float>(i / 64));
  return cloud;
}

Cloud with_copies() {
  Cloud cloud = random_points(300, 1.0, 1);
  cloud.points.insert(cloud.points.end(), cloud.points.begin(), cloud.points.begin() + 150);
  return cloud;
}

Cloud with_outliers() {
  Cloud cloud = random_points(300, 1.0, 2);
  for (float far : {1e6f, 1e18f, 3e19f, 3e38f}) cloud.points.emplace_back(far, -far, 0.0f);
  return cloud;
}

Cloud scaled_queries(Cloud cloud, float scale) {
  for (Vec3f& point : cloud.points) point *= scale;
  return cloud;
}

std::vector<MemoryCase> cases() {
  return {{"random", random_points(2000, 1.0, 3), 1.0},
          {"ties", remembered_grid(), 8.0},
          {"copies", with_copies(), 1.0},
          {"outliers", with_outliers(), 1.0},
          {"one point", random_points(1, 1.0, 4), 1.0},
          {"two points", random_points(2, 1.0, 5), 1.0},
          {"no point", {}, 1.0},
          {"squares below float", scaled_queries(random_points(300, 1.0, 6), 1e-21f), 1e-21},
          {"squares hardly in float", scaled_queries(random_points(300, 1.0, 6), 1e-22f), 1e-22},
          {"squares above float", scaled_queries(random_points(300, 1.0, 7), 3e19f), 3e19}};
}

void expect_same(const std::optional<Neighbour>& found, const std::optional<Neighbour>& expected,
                 const std::string& name) {
  ASSERT_EQ(found.has_value(), expected.has_value()) << name;
  if (!found) return;
  EXPECT_EQ(found->index, expected->index) << name;
  EXPECT_EQ(found->distance_sq, expected->distance_sq) << name;
}

// Queries that come again and again, moved by hardly anything to everything, under gates that open and close.
void expect_as_searched(const MemoryCase& of, unsigned seed) {
  const KdTree tree(of.cloud);
  NearestMemory memory(tree, kNumQueries);
  std::mt19937 generator(seed);
  std::vector<Vec3f> places =
      scaled_queries(random_points(kNumQueries, 1.2, seed), static_cast<float>(of.extent)).points;
  for (const double step : {1.0, 1e-3, 0.3, 0.03, 0.0, 1e-2, 1e-7, 0.1, 1e-4, 3.0, 1e-3}) {
    const double gate = of.extent * testing::uniform(generator, 0.0, 0.5);
    const float max_distance_sq = step == 0.03 ? kInfinity : static_cast<float>(gate * gate);
    for (std::size_t k = 0; k < kNumQueries; ++k) {
      places[k] += (step * of.extent * testing::random_direction(generator)).cast<float>();
      const std::size_t likely = k == 0 ? k : k - 1;
      expect_same(memory.nearest(k, places[k], max_distance_sq, likely), tree.nearest(places[k], max_distance_sq),
                  of.name);
    }
  }
}

TEST(NearestMemory, FindsWhatASearchFinds) {
  for (const MemoryCase& of : cases())
    for (unsigned seed : {11u, 12u, 13u}) expect_as_searched(of, seed);
}

// Three points as near as each other, and a fourth behind a mirror: by steps of the last digit across it.
TEST(NearestMemory, ChangesFromOnePointToTheNextWhereASearchDoes) {
  Cloud cloud;
  cloud.points = {{0.0f, 0.4f, 0.0f}, {0.0f, 0.0f, -0.4f}, {0.0f, -0.4f, 0.0f}, {1.0f, 0.0f, 0.4f}};
  const KdTree tree(cloud);
  NearestMemory memory(tree, 1);
  for (float x = 0.5f - 1e-6f; x < 0.5f + 1e-6f; x = std::nextafter(x, 1.0f)) {
    const Vec3f place(x, 0.0f, 0.0f);
    expect_same(memory.nearest(0, place, kInfinity, 0), tree.nearest(place, kInfinity), "the mirror");
  }
}

// A query that comes from the side of the later point to the mirror between two.
TEST(NearestMemory, OfTwoAsNearTheFirstIsFound) {
  Cloud cloud;
  cloud.points = {{1.0f, 0.0f, 0.0f}, {0.0f, 0.0f, 0.0f}};
  const KdTree tree(cloud);
  NearestMemory memory(tree, 1);
  EXPECT_EQ(memory.nearest(0, Vec3f(0.4f, 0.0f, 0.0f), kInfinity, 0)->index, 1u);
  EXPECT_EQ(memory.nearest(0, Vec3f(0.5f, 0.0f, 0.0f), kInfinity, 0)->index, 0u);
}

TEST(NearestMemory, NoPointIsFoundAtTheGate) {
  Cloud cloud;
  cloud.points = {{0.0f, 0.0f, 0.0f}, {5.0f, 0.0f, 0.0f}};
  const KdTree tree(cloud);
  NearestMemory memory(tree, 1);
  for (const float x : {0.25f, 0.0f}) {
    const Vec3f place(x, 0.0f, 0.0f);
    EXPECT_EQ(memory.nearest(0, place, kInfinity, 0)->index, 0u);
    EXPECT_FALSE(memory.nearest(0, place, x * x, 0)) << x;
  }
}

// Four points, one of them not remembered. The query moves straight away from the nearest to the middle between these
// two; the last digits decide which is nearer.
TEST(NearestMemory, RoundingHidesNoPoint) {
  std::mt19937 generator(9);
  for (int trial = 0; trial < 20000; ++trial) {
    const Vec3d from = trial % 2 == 0 ? Vec3d::Zero().eval() : testing::random_direction(generator);
    const Vec3d along = testing::random_direction(generator);
    const Vec3d across = along.cross(testing::random_direction(generator)).normalized();
    const double behind = testing::uniform(generator, 0.05, 0.95);
    const double step = (1.0 - behind) / 2.0 * (1.0 + 3e-7 * testing::uniform(generator, -1.0, 1.0));
    Cloud cloud;
    for (const Vec3d& to : {Vec3d((1.0 - 1e-7) * across), Vec3d((2e-7 - 1.0) * across), along, Vec3d(-behind * along)})
      cloud.points.push_back((from + to).cast<float>());
    const KdTree tree(cloud);
    NearestMemory memory(tree, 1);
    for (const Vec3d& at : {from, Vec3d(from + step * along)}) {
      const Vec3f place = at.cast<float>();
      expect_same(memory.nearest(0, place, kInfinity, 0), tree.nearest(place, kInfinity), std::to_string(trial));
    }
  }
}

// The other point is so far at first that the square of its distance is no float.
TEST(NearestMemory, ForgetsNoPointBeyondFloat) {
  Cloud cloud;
  cloud.points = {{0.0f, 0.0f, 0.0f}, {3e19f, 0.0f, 0.0f}};
  const KdTree tree(cloud);
  NearestMemory memory(tree, 1);
  for (float x : {0.0f, 1.7e19f}) {
    const Vec3f place(x, 0.0f, 0.0f);
    expect_same(memory.nearest(0, place, kInfinity, 0), tree.nearest(place, kInfinity), std::to_string(x));
  }
}

TEST(NearestMemory, OutlivesPlacesThatAreNotNumbers) {
  const Cloud cloud = random_points(100, 1.0, 8);
  const KdTree tree(cloud);
  NearestMemory memory(tree, 1);
  const Vec3f place(0.1f, 0.2f, 0.3f);
  for (const float bad : {std::nanf(""), kInfinity}) {
    expect_same(memory.nearest(0, place, 4.0f, 0), tree.nearest(place, 4.0f), "before");
    EXPECT_FALSE(memory.nearest(0, Vec3f(0.0f, bad, 0.0f), 4.0f, 0));
    expect_same(memory.nearest(0, place, 4.0f, 0), tree.nearest(place, 4.0f), "after");
  }
}

}  // namespace
}  // namespace augicp
