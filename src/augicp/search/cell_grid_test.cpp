// SPDX-License-Identifier: MIT
#include "augicp/search/cell_grid.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <limits>
#include <random>
#include <stdexcept>

#include "augicp/testing/poses.h"

namespace augicp {
namespace {

using testing::uniform;

Cloud random_cloud(int count, double size, const Vec3d& corner) {
  std::mt19937 generator(7);
  Cloud cloud;
  for (int i = 0; i < count; ++i)
    cloud.points.push_back(
        (corner + Vec3d(uniform(generator, 0, size), uniform(generator, 0, size), uniform(generator, 0, size)))
            .cast<float>());
  return cloud;
}

// The points around each cell, in ascending order.
std::vector<std::vector<std::uint32_t>> around_cells(const CellGrid& grid, std::size_t first_cell = 0) {
  std::vector<std::vector<std::uint32_t>> around(grid.num_cells() - first_cell);
  CellGrid::Walk walk(grid, first_cell);
  for (auto& points : around) {
    walk.next(points);
    std::sort(points.begin(), points.end());
  }
  return around;
}

// Whatever is near a point is around its cell; checked against all pairs.
void expect_nothing_missed(const Cloud& cloud, double distance) {
  const CellGrid grid(cloud, distance);
  const auto around_cell = around_cells(grid);
  std::size_t num_points = 0;
  for (std::size_t cell = 0; cell < grid.num_cells(); ++cell) {
    const std::vector<std::uint32_t>& around = around_cell[cell];
    ASSERT_EQ(std::adjacent_find(around.begin(), around.end()), around.end());
    ASSERT_TRUE(std::is_sorted(grid.points_of(cell).begin(), grid.points_of(cell).end()));
    num_points += grid.points_of(cell).size();
    for (const std::uint32_t i : grid.points_of(cell))
      for (std::uint32_t k = 0; k < cloud.size(); ++k) {
        const bool is_near = static_cast<double>((cloud.points[k] - cloud.points[i]).norm()) < distance;
        ASSERT_TRUE(!is_near || std::binary_search(around.begin(), around.end(), k)) << i << " and " << k;
      }
  }
  EXPECT_EQ(num_points, cloud.size());
}

TEST(CellGrid, NothingNearIsMissed) {
  for (const Vec3d& corner : {Vec3d(0, 0, 0), Vec3d(-0.5, -3.0, 40.0), Vec3d(-1e6, 1e6, 0.0)})
    for (double distance : {1e-9, 0.03, 0.2, 5.0}) expect_nothing_missed(random_cloud(400, 1.0, corner), distance);
}

// Points on the faces of cells, whose quotients are rounded to either side.
TEST(CellGrid, NothingIsMissedWhereCellsMeet) {
  Cloud cloud;
  const double distance = 0.1;
  for (int k = 0; k < 300; ++k) cloud.points.push_back(Vec3d(0.999 * distance * k, 0.0, distance * k).cast<float>());
  expect_nothing_missed(cloud, distance);
  expect_nothing_missed(cloud, 1.0000001 * distance);
}

TEST(CellGrid, FarOutliersAreCellsOfTheirOwn) {
  Cloud cloud = random_cloud(100, 1.0, Vec3d::Zero());
  for (float far : {1e9f, 1e17f, -1e17f}) cloud.points.push_back(Vec3f(far, 0.0f, 0.0f));
  expect_nothing_missed(cloud, 0.1);
  cloud.points.assign(50, Vec3f(1e17f, -1e17f, 3.0f));
  EXPECT_EQ(CellGrid(cloud, 1e-6).num_cells(), 1u);
}

// Far points must not take digits from the others' places, whatever side they are on.
TEST(CellGrid, NothingIsMissedBesideAFarOutlier) {
  for (float far : {1e18f, -1e18f, -1e10f}) {
    Cloud cloud;
    for (float x : {far, 63.9f, 64.1f, 64.3f, -0.05f, 0.05f})
      cloud.points.push_back(Vec3f(x, far > 0.0f ? 0.0f : x, 0.0f));
    for (double distance : {1.0, 0.21, 1e-6}) expect_nothing_missed(cloud, distance);
  }
}

// robustness 10: neither far outliers nor a distance near zero put the points into few cells, which would mean all
// pairs.
TEST(CellGrid, CellsHoldFewPoints) {
  Cloud cloud = random_cloud(2000, 1.0, Vec3d(5.0, -5.0, 0.0));
  const std::size_t num_cells = CellGrid(cloud, 0.01).num_cells();
  EXPECT_GT(num_cells, 1900u);
  for (double distance : {1e-8, 1e-20, 1e-300}) EXPECT_GT(CellGrid(cloud, distance).num_cells(), 1990u);
  cloud.points.push_back(Vec3f::Constant(-1e18f));
  EXPECT_EQ(CellGrid(cloud, 0.01).num_cells(), num_cells + 1);
}

TEST(CellGrid, WhatIsAroundIsNotMuchMore) {
  const Cloud cloud = random_cloud(5000, 1.0, Vec3d::Zero());
  const CellGrid grid(cloud, 0.1);
  const auto around = around_cells(grid);
  for (std::size_t cell = 0; cell < grid.num_cells(); ++cell) {
    const Vec3f& centre = cloud.points[grid.points_of(cell).front()];
    for (const std::uint32_t i : around[cell]) EXPECT_LT((cloud.points[i] - centre).cwiseAbs().maxCoeff(), 0.2001f);
  }
}

TEST(CellGrid, AWalkMayBeginAnywhere) {
  const CellGrid grid(random_cloud(2000, 1.0, Vec3d(-0.4, 0.0, 3.0)), 0.1);
  const auto from_the_first = around_cells(grid);
  for (std::size_t first : {std::size_t{1}, std::size_t{7}, grid.num_cells() / 2, grid.num_cells() - 1}) {
    const auto from_there = around_cells(grid, first);
    EXPECT_TRUE(
        std::equal(from_there.begin(), from_there.end(), from_the_first.begin() + static_cast<std::ptrdiff_t>(first)));
  }
}

TEST(CellGrid, NoPointsNoCells) { EXPECT_EQ(CellGrid(Cloud{}, 1.0).num_cells(), 0u); }

TEST(CellGrid, RefusesDistancesThatAreNone) {
  for (double distance : {0.0, -1.0, std::numeric_limits<double>::infinity(), std::numeric_limits<double>::quiet_NaN()})
    EXPECT_THROW(CellGrid(Cloud{}, distance), std::invalid_argument);
}

}  // namespace
}  // namespace augicp
