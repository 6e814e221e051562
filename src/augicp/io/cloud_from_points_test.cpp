// SPDX-License-Identifier: MIT
#include "augicp/io/cloud_from_points.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <span>
#include <stdexcept>
#include <vector>

#include "augicp/io/read_cloud.h"

namespace augicp {
namespace {

constexpr double kNoNumber = std::numeric_limits<double>::quiet_NaN();

PointSource source_of(const std::vector<Vec3d>& points) {
  PointSource source;
  source.count = points.size();
  source.position = [&points](std::size_t i) { return points[i]; };
  return source;
}

// Far from zero, so that both choose an origin.
TEST(CloudFromPoints, EqualsAFileWithTheSameNumbers) {
  const std::vector<Vec3d> points{{4e6, 1.5, 2.0}, {4e6 + 0.25, 1.0, kNoNumber}, {4e6 + 1.0, 0.5, 0.125}};
  const FileBytes file{"a.xyz", "4000000 1.5 2\n4000000.25 1 nan\n4000001 0.5 0.125\n"};
  const CloudFile expected = parse_cloud(file), found = cloud_from_points(source_of(points));
  EXPECT_EQ(found.cloud.points, expected.cloud.points);
  EXPECT_EQ(found.cloud.origin, expected.cloud.origin);
  EXPECT_EQ(found.report.num_not_finite, 1u);
  EXPECT_FALSE(found.cloud.has_directions());
}

TEST(CloudFromPoints, NormalsAreOfPlanesUnlessToldOtherwise) {
  const std::vector<Vec3d> points{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}};
  PointSource source = source_of(points);
  source.normal = [](std::size_t) { return Vec3d(0, 0, 2); };
  EXPECT_THAT(cloud_from_points(source).cloud.structures, ::testing::Each(Structure::Planar));
  source.structure = [](std::size_t i) { return static_cast<Structure>(i); };
  const Cloud cloud = cloud_from_points(source).cloud;
  EXPECT_THAT(cloud.structures, ::testing::ElementsAre(Structure::None, Structure::Planar, Structure::Edge));
  EXPECT_EQ(cloud.directions, (std::vector<Vec3f>{{0, 0, 0}, {0, 0, 1}, {0, 0, 1}}));
}

TEST(CloudFromPoints, ManyAtOnceAreTheSameAsOneByOne) {
  std::vector<Vec3d> points;
  for (int i = 0; i < 1000; ++i) points.emplace_back(1e6 + 0.1 * i, i % 7, i % 100 == 3 ? kNoNumber : 0.5);
  PointSource source = source_of(points);
  const CloudFile expected = cloud_from_points(source);
  source.position = {};
  source.positions = [&](std::size_t first, std::span<Vec3d> positions) {
    std::copy_n(points.begin() + static_cast<std::ptrdiff_t>(first), positions.size(), positions.begin());
  };
  const CloudFile alone = cloud_from_points(source);
  EXPECT_EQ(alone.cloud.points, expected.cloud.points);
  EXPECT_EQ(alone.cloud.origin, expected.cloud.origin);
  EXPECT_EQ(alone.report.num_declared, 1000u);
  EXPECT_EQ(alone.report.num_not_finite, 10u);
  source.intensity = [](std::size_t i) { return static_cast<double>(i); };
  const CloudFile with_more = cloud_from_points(source);
  EXPECT_EQ(with_more.cloud.points, expected.cloud.points);
  EXPECT_EQ(with_more.cloud.intensities.size(), 990u);
}

TEST(CloudFromPoints, MayBeEmpty) {
  EXPECT_TRUE(cloud_from_points(source_of({})).cloud.empty());
  const std::vector<Vec3d> nowhere{{kNoNumber, 0, 0}};
  EXPECT_TRUE(cloud_from_points(source_of(nowhere)).cloud.empty());
}

TEST(CloudFromPoints, TooManyAreRefusedBeforeAnyIsAskedFor) {
  PointSource source;
  source.count = ReadOptions{}.max_points + 1;
  EXPECT_THROW(cloud_from_points(source), std::invalid_argument);
}

}  // namespace
}  // namespace augicp
