// SPDX-License-Identifier: MIT
#include "augicp/global/descriptors.h"

#include <gmock/gmock.h>

#include <cmath>
#include <numeric>

#include "augicp/global/key_testing.h"
#include "augicp/global/pair_histogram.h"

namespace augicp {
namespace {

float product(const Descriptor& a, const Descriptor& b) {
  return std::inner_product(a.begin(), a.end(), b.begin(), 0.0f);
}

// The large ball's cloud is downsampled anew, so that a few points of it differ in another frame.
double mean_product(const KeyPoints& a, const KeyPoints& b) {
  double sum = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += product(a.descriptors[i], b.descriptors[i]);
  return sum / static_cast<double>(a.size());
}

constexpr std::size_t kAll = 100000;

TEST(Descriptors, HaveOneNorm) {
  const KeyPoints keys = described(key_cloud_of_a_chair(1), kAll, 1);
  ASSERT_GT(keys.size(), 500u);
  for (const Descriptor& descriptor : keys.descriptors)
    EXPECT_NEAR(product(descriptor, descriptor), kDescriptorNorm, 1e-4f);
}

TEST(Descriptors, StayTheSameInAnotherFrame) {
  const KeyCloud cloud = key_cloud_of_a_chair(1);
  std::mt19937 generator(2);
  const Rigid3 motion = testing::random_motion(generator, 1.2, 0.4);
  const KeyPoints keys = described(cloud, kAll, 1), others = described(moved(cloud, motion), kAll, 1);
  ASSERT_EQ(keys.size(), others.size());
  EXPECT_GT(mean_product(keys, others), 0.97 * kDescriptorNorm);
}

TEST(Descriptors, DoNotDependOnSignsThatAreNotKnown) {
  const KeyCloud cloud = key_cloud_of_a_chair(1);
  KeyCloud flipped = cloud;
  std::mt19937 generator(3);
  for (Vec3f& normal : flipped.normals)
    if (generator() % 2) normal = -normal;
  const KeyPoints keys = described(cloud, kAll, 1), others = described(flipped, kAll, 1);
  ASSERT_EQ(keys.size(), others.size());
  for (std::size_t i = 0; i < keys.size(); ++i) {
    EXPECT_NEAR(product(keys.descriptors[i], others.descriptors[i]), kDescriptorNorm, 1e-3f);
    EXPECT_GT(keys.normals[i].dot(others.normals[i]), 0.0f);
  }
}

TEST(Descriptors, KnownSignsTellBumpsFromHollows) {
  const KeyCloud outside = key_cloud_of_a_chair(1, Vec3f(5.0f, 0.0f, 0.0f));
  KeyCloud inside = outside;
  for (Vec3f& normal : inside.normals) normal = -normal;
  const KeyPoints keys = described(outside, kAll, 1), others = described(inside, kAll, 1);
  EXPECT_LT(mean_product(keys, others), 0.97 * kDescriptorNorm);
  for (std::size_t i = 0; i < keys.size(); ++i) EXPECT_EQ(keys.normals[i], -others.normals[i]);
}

TEST(Descriptors, OfTheMostVariedPoints) {
  const KeyCloud cloud = key_cloud_of_a_chair(1);
  const KeyPoints few = described(cloud, 100, 1);
  EXPECT_EQ(few.size(), 100u);
  std::vector<float> variation = cloud.variation;
  std::sort(variation.rbegin(), variation.rend());
  for (const Vec3f& point : few.points) {
    const auto at = std::find(cloud.points.begin(), cloud.points.end(), point);
    EXPECT_GE(cloud.variation[static_cast<std::size_t>(at - cloud.points.begin())], variation[110]);
  }
}

TEST(Descriptors, SameBitsOnAnyNumberOfThreads) {
  const KeyCloud cloud = key_cloud_of_a_chair(1);
  const KeyPoints alone = described(cloud, 700, 1);
  for (const int num_threads : {2, 5, 8}) EXPECT_EQ(described(cloud, 700, num_threads).descriptors, alone.descriptors);
}

TEST(Descriptors, ACloudWithoutSurfaceHasNone) {
  EXPECT_EQ(described(key_cloud({}, 1.0, std::nullopt, 1), 10, 1).size(), 0u);
  Cloud line;
  for (int k = 0; k < 100; ++k) line.points.emplace_back(0.1f * static_cast<float>(k), 0.0f, 0.0f);
  EXPECT_EQ(described(key_cloud(line, 0.1, std::nullopt, 1), 10, 1).size(), 0u);
}

TEST(PairHistogram, SidesAreToldOnPlaneSphereAndCrease) {
  const Vec3f up = Vec3f::UnitZ(), here = Vec3f::Zero(), beside(0.3f, 0.1f, 0.0f), wall(0.3f, 0.0f, 0.3f);
  const Vec3f towards_floor = -Vec3f::UnitX();
  EXPECT_TRUE(are_on_same_side({here, up}, {beside, up}));
  EXPECT_FALSE(are_on_same_side({here, up}, {beside, -up}));
  EXPECT_TRUE(are_on_same_side({here, up}, {wall, towards_floor}));
  EXPECT_FALSE(are_on_same_side({here, up}, {wall, -towards_floor}));
  std::mt19937 generator(1);
  for (int k = 0; k < 20; ++k) {
    const Vec3f a = testing::random_direction(generator).cast<float>(),
                b = testing::random_direction(generator).cast<float>();
    EXPECT_TRUE(are_on_same_side({a, a}, {b, b}));
    EXPECT_FALSE(are_on_same_side({a, a}, {b, -b}));
  }
}

TEST(PairHistogram, ABumpBendsAwayFromItsNormal) {
  std::vector<Vec3f> points, normals;
  std::mt19937 generator(1);
  for (int k = 0; k < 200; ++k) points.push_back(testing::random_direction(generator).cast<float>());
  normals = points;
  std::vector<std::uint32_t> all(points.size());
  std::iota(all.begin(), all.end(), 0u);
  const Vec3f top = Vec3f::UnitZ(), outside = Vec3f::UnitZ(), inside = -outside;
  const PairHistogram bump = pair_histogram({top, outside}, {points, normals}, all, false),
                      hollow = pair_histogram({top, inside}, {points, normals}, all, false);
  EXPECT_LT(bump.bend(), 0.0f);
  for (std::size_t b = 0; b < bump.bins.size(); ++b) EXPECT_NEAR(opposite(bump).bins[b], hollow.bins[b], 1e-5f);
}

}  // namespace
}  // namespace augicp
