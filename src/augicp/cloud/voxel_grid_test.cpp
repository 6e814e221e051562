// SPDX-License-Identifier: MIT
#include "augicp/cloud/voxel_grid.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <random>
#include <tuple>

#include "augicp/testing/poses.h"

namespace augicp {
namespace {

Cloud random_cloud(int count, double half_extent) {
  std::mt19937 generator(11);
  Cloud cloud;
  const auto coordinate = [&] { return static_cast<float>(testing::uniform(generator, -half_extent, half_extent)); };
  for (int i = 0; i < count; ++i) {
    const float x = coordinate(), y = coordinate(), z = coordinate();
    cloud.points.emplace_back(x, y, z);
  }
  return cloud;
}

Cloud shuffled(const Cloud& cloud) {
  std::vector<std::uint32_t> indices(cloud.size());
  std::iota(indices.begin(), indices.end(), 0u);
  std::shuffle(indices.begin(), indices.end(), std::mt19937(5));
  return select(cloud, indices);
}

TEST(VoxelGrid, EachVoxelGivesTheMeanOfItsPoints) {
  const Cloud cloud = random_cloud(2000, 1.0);
  const double voxel_size = 0.3;
  const Vec3f min = bounds(cloud).min;
  std::map<std::tuple<int, int, int>, std::vector<Vec3f>> voxels;
  for (const Vec3f& p : cloud.points) {
    const auto cell = [&](int k) { return static_cast<int>(std::floor((double(p[k]) - double(min[k])) / voxel_size)); };
    voxels[{cell(0), cell(1), cell(2)}].push_back(p);
  }
  const Cloud sampled = downsample(cloud, voxel_size);
  ASSERT_EQ(sampled.size(), voxels.size());
  for (const auto& [cell, members] : voxels) {
    Vec3f mean = Vec3f::Zero();
    for (const Vec3f& p : members) mean += p / static_cast<float>(members.size());
    const bool found = std::any_of(sampled.points.begin(), sampled.points.end(),
                                   [&](const Vec3f& p) { return (p - mean).norm() < 1e-5f; });
    EXPECT_TRUE(found);
  }
}

TEST(VoxelGrid, IntensityIsTheMeanOfTheKnownOnes) {
  const float unknown = std::numeric_limits<float>::quiet_NaN();
  Cloud cloud;
  cloud.points = {{0.0f, 0.0f, 0.0f}, {0.1f, 0.0f, 0.0f}, {0.2f, 0.0f, 0.0f}, {5.0f, 0.0f, 0.0f}};
  cloud.intensities = {1.0f, unknown, 2.0f, unknown};
  cloud.intensity_gradients = {Vec3f::UnitX(), Vec3f::UnitY(), Vec3f::UnitZ(), Vec3f::Zero()};
  const Cloud sampled = downsample(cloud, 1.0);
  ASSERT_EQ(sampled.intensities.size(), 2u);
  EXPECT_EQ(sampled.intensities[0], 1.5f);
  EXPECT_TRUE(std::isnan(sampled.intensities[1]));
  EXPECT_EQ(sampled.intensity_gradients, (std::vector<Vec3f>{Vec3f::UnitY(), Vec3f::Zero()}));
  EXPECT_EQ(select(cloud, {2, 0}).intensities, (std::vector<float>{2.0f, 1.0f}));
  EXPECT_TRUE(downsample(random_cloud(100, 1.0), 0.3).intensities.empty());
}

TEST(VoxelGrid, OrderOfThePointsDoesNotMatter) {
  Cloud cloud = random_cloud(5000, 2.0);
  const auto expect_same = [&] {
    const Cloud one = downsample(cloud, 0.2), other = downsample(shuffled(cloud), 0.2);
    EXPECT_EQ(one.points, other.points);
    EXPECT_EQ(one.weights, other.weights);
    EXPECT_EQ(one.intensities, other.intensities);
  };
  expect_same();
  for (const Vec3f& point : random_cloud(5000, 1.0).points) {
    cloud.intensities.push_back(std::exp(20.0f * point.x()));  // its sums depend on the order
    cloud.weights.push_back(point.y());
  }
  expect_same();
}

// Other attributes do not change the positions of points.
TEST(VoxelGrid, PointsAreTheSameWithAllElse) {
  const Cloud bare = random_cloud(5000, 2.0);
  Cloud cloud = bare;
  cloud.weights.assign(cloud.size(), 1.0f);
  EXPECT_EQ(downsample(cloud, 0.2).points, downsample(bare, 0.2).points);
}

TEST(VoxelGrid, VoxelsFarLargerThanTheCloudGiveItsMean) {
  Cloud cloud;
  cloud.points = {{0.0f, 0.0f, 0.0f}, {1.0f, 1e-5f, 3.0f}};
  for (double voxel_size : {7.0, 1e3, 1e8, 1e20, 1e300}) {
    const Cloud sampled = downsample(cloud, voxel_size);
    ASSERT_EQ(sampled.size(), 1u);
    EXPECT_LT((sampled.points[0] - Vec3f(0.5f, 5e-6f, 1.5f)).norm(), 1e-7f) << voxel_size;
  }
}

TEST(VoxelGrid, LonePointsStayAsTheyAre) {
  Cloud cloud;
  cloud.points = {{1e-7f, -1e-9f, 3e-8f}, {1.1f, 1e-7f, -1e-12f}, {-7.3f, 1e-6f, 5.0f}};
  EXPECT_THAT(downsample(cloud, 1.0).points, ::testing::UnorderedElementsAreArray(cloud.points));
}

// With the largest number of cells along an axis, the last is not the first.
TEST(VoxelGrid, TheLastCellIsACellOfItsOwn) {
  Cloud cloud;
  cloud.points = {{0.0f, 0.0f, 0.0f}, {1.0f, 0.0f, 0.0f}};
  double voxel_size = 1.0 / (1 << 21);
  while (1.0 / voxel_size >= 1 << 21) voxel_size = std::nextafter(voxel_size, 1.0);
  EXPECT_EQ(downsample(cloud, voxel_size).points, cloud.points);
}

// Two points as near to the mean as each other: which of them lends its direction does not depend on their order.
TEST(VoxelGrid, OrderDoesNotDecideBetweenEquallyNearMembers) {
  for (int axis = 0; axis < 3; ++axis) {
    Cloud cloud;
    cloud.points = {-Vec3f::Unit(axis), Vec3f::Unit(axis)};
    cloud.directions = {Vec3f::UnitX(), Vec3f::UnitY()};
    cloud.structures = {Structure::Planar, Structure::Edge};
    const Cloud one = downsample(cloud, 10.0), other = downsample(select(cloud, {1, 0}), 10.0);
    ASSERT_EQ(one.size(), 1u);
    EXPECT_EQ(one.directions, other.directions) << axis;
    EXPECT_EQ(one.structures, other.structures) << axis;
  }
}

// The Morton curve by its definition: of two cells that axis decides in which they differ by the highest bit, z before
// y before x.
bool is_before_on_curve(const Vec3f& p, const Vec3f& q) {
  const auto bits = [&](int axis) {
    return std::bit_width(static_cast<std::uint32_t>(p[axis]) ^ static_cast<std::uint32_t>(q[axis]));
  };
  int first = 2;
  for (int axis : {1, 0})
    if (bits(axis) > bits(first)) first = axis;
  return p[first] < q[first];
}

// Cells with few bits and with all 21 an axis.
TEST(VoxelGrid, VoxelsFollowTheCurve) {
  for (double size : {3.0, 40.0, 2000.0, 1e6}) {
    Cloud cloud = random_cloud(3000, size);
    for (Vec3f& point : cloud.points)
      for (float& coordinate : point) coordinate = std::floor(coordinate + static_cast<float>(size)) + 0.5f;
    cloud.points.push_back(Vec3f::Constant(0.5f));  // the grid's corner
    const Cloud sampled = downsample(cloud, 1.0);
    for (std::size_t i = 1; i < sampled.size(); ++i)
      ASSERT_TRUE(is_before_on_curve(sampled.points[i - 1], sampled.points[i])) << size << ", " << i;
  }
}

TEST(VoxelGrid, EqualPointsBecomeOne) {
  Cloud cloud;
  cloud.points.assign(5000, Vec3f(1.0f, 2.0f, 3.0f));
  for (double voxel_size : {0.1, 1e9, 1e-300})
    EXPECT_EQ(downsample(cloud, voxel_size).points, std::vector<Vec3f>{Vec3f(1.0f, 2.0f, 3.0f)});
}

TEST(VoxelGrid, AreCountedAsThePointsThatStay) {
  Cloud cloud = random_cloud(5000, 1.0);
  cloud.points.insert(cloud.points.end(), 3, Vec3f(0.5f, 0.5f, 0.5f));
  for (const double voxel_size : {1e-3, 0.05, 0.3, 10.0})
    EXPECT_EQ(count_voxels(cloud, voxel_size), downsample(cloud, voxel_size).size()) << voxel_size;
  Cloud one;
  EXPECT_EQ(count_voxels(one, 1.0), 0u);
  one.points = {Vec3f::Zero()};
  EXPECT_EQ(count_voxels(one, 1.0), 1u);
}

// Few voxels are summed as they come, many are sorted, and so are those of points with attributes.
TEST(VoxelGrid, FewAndManyVoxelsHaveTheSameMeans) {
  Cloud bare = random_cloud(60000, 1.0);
  Cloud weighted = bare;
  weighted.weights.assign(weighted.size(), 1.0f);
  for (const double voxel_size : {0.01, 0.03, 0.041, 0.2})
    EXPECT_EQ(downsample(bare, voxel_size).points, downsample(weighted, voxel_size).points) << voxel_size;
}

TEST(VoxelGrid, DirectionsComeFromAMember) {
  Cloud cloud;
  cloud.points = {{0.0f, 0.0f, 0.0f}, {0.01f, 0.0f, 0.0f}, {0.05f, 0.0f, 0.0f}};
  cloud.directions = {{1.0f, 0.0f, 0.0f}, {0.0f, 1.0f, 0.0f}, {0.0f, 0.0f, 1.0f}};
  cloud.structures = {Structure::Planar, Structure::Edge, Structure::Planar};
  cloud.gaussians.resize(3);
  cloud.gaussians[1].mean = {0.02f, 0.0f, 0.0f};
  const Cloud sampled = downsample(cloud, 1.0);
  ASSERT_EQ(sampled.size(), 1u);
  EXPECT_EQ(sampled.directions[0], Vec3f(0.0f, 1.0f, 0.0f));
  ASSERT_EQ(sampled.gaussians.size(), 1u);
  EXPECT_EQ(sampled.gaussians[0].mean, cloud.gaussians[1].mean);
  EXPECT_EQ(sampled.structures[0], Structure::Edge);
}

TEST(EvenlyChosen, AreNoMoreThanAskedAndSpreadOverAll) {
  const Cloud cloud = random_cloud(1000, 1.0);
  for (const std::size_t max_count : {1u, 7u, 300u, 999u, 1000u, 5000u}) {
    const Cloud chosen = evenly_chosen(cloud, max_count);
    EXPECT_LE(chosen.size(), max_count);
    EXPECT_GE(2 * chosen.size(), std::min(max_count, cloud.size()));
    const std::size_t step = (cloud.size() + chosen.size() - 1) / chosen.size();
    for (std::size_t k = 0; k < chosen.size(); ++k) EXPECT_EQ(chosen.points[k], cloud.points[k * step]);
  }
  EXPECT_TRUE(evenly_chosen(Cloud{}, 5).empty());
}

TEST(VoxelGrid, BadSizesAreRefused) {
  const Cloud cloud = random_cloud(10, 1.0);
  for (double voxel_size : {0.0, -1.0, std::nan(""), 1e-9}) {
    EXPECT_THROW(downsample(cloud, voxel_size), std::invalid_argument);
    EXPECT_THROW(count_voxels(cloud, voxel_size), std::invalid_argument);
  }
  EXPECT_TRUE(downsample(Cloud{}, 0.1).empty());
}

}  // namespace
}  // namespace augicp
