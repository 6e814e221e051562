// SPDX-License-Identifier: MIT
#include "augicp/io/cloud_builder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "augicp/testing/matchers.h"
#include "augicp/testing/poses.h"

namespace augicp {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

CloudFile build(const std::vector<PointValues>& points, PointTable table = {}) {
  table.num_points = points.size();
  return build_cloud(FileBytes{"file", ""}, table, [&](CloudBuilder& builder) {
    for (const PointValues& point : points) builder.add(point);
  });
}

std::vector<PointValues> points_around(const Vec3d& centre, double radius) {
  std::mt19937 generator(3);
  std::vector<PointValues> points;
  for (int i = 0; i < 100; ++i) {
    const Vec3d p = centre + radius * testing::random_direction(generator);
    points.push_back({p.x(), p.y(), p.z()});
  }
  return points;
}

TEST(CloudBuilder, OriginIsZeroForCloudsNearZero) {
  for (double radius : {1e-3, 1.0, 1e4})
    for (double distance_in_radii : {0.0, 1.0, 5.0})
      EXPECT_EQ(build(points_around(Vec3d(0, -distance_in_radii * radius, 0), radius)).cloud.origin, Vec3d::Zero());
}

// Float alone would lose 1e-7 of the distance.
TEST(CloudBuilder, CloudsFarFromZeroLoseNothing) {
  for (double distance : {1e3, 1e6, 1e7, 1e12}) {
    std::vector<PointValues> points = points_around(Vec3d(distance, -distance, 0.5 * distance), 10.0);
    points.push_back({0.0, 0.0, 0.0});  // "no reading": does not decide
    const Cloud cloud = build(points).cloud;
    for (std::size_t i = 0; i + 1 < points.size(); ++i)
      EXPECT_THAT(cloud.origin + cloud.points[i].cast<double>(),
                  testing::NearVector(Vec3d(points[i][0], points[i][1], points[i][2]), 1e-6 + 1e-15 * distance));
  }
}

TEST(CloudBuilder, OneFarPointHasAnOriginToo) {
  EXPECT_EQ(build({{4e6 + 0.25, 0, 0}}).cloud.origin, Vec3d(4e6, 0, 0));
  EXPECT_EQ(build({{4e6 + 0.25, 0, 0}}).cloud.points.front().x(), 0.25f);
}

TEST(CloudBuilder, ViewpointMovesWithTheOrigin) {
  PointTable table;
  table.viewpoint = Vec3d(1e6, 0.0, 2.0);
  const Cloud cloud = build(points_around(Vec3d(1e6, 0.0, 0.0), 10.0), table).cloud;
  EXPECT_GT(cloud.origin.norm(), 0.0);
  EXPECT_EQ(cloud.origin + cloud.viewpoint->cast<double>(), *table.viewpoint);
}

// robustness 4
TEST(CloudBuilder, DropsAndCountsWhatIsNotFinite) {
  const double infinity = std::numeric_limits<double>::infinity();
  PointTable table;
  table.width = 2;
  const CloudFile file =
      build({{1, 2, 3}, {kNan, 0, 0}, {0, infinity, 0}, {0, 0, -1e308}, {1e-310, 0, 0}, {0, 0, 1e19}}, table);
  EXPECT_EQ(file.cloud.points, (std::vector<Vec3f>{{1, 2, 3}, {0, 0, 0}}));
  EXPECT_EQ(file.report.num_declared, 6u);
  EXPECT_EQ(file.report.num_not_finite, 4u);
  ASSERT_TRUE(file.grid);
  EXPECT_EQ(file.grid->height, 3);
  EXPECT_EQ(file.grid->index, (std::vector<std::int32_t>{0, -1, -1, -1, 1, -1}));
}

// robustness 4
TEST(CloudBuilder, NothingFiniteIsAnError) {
  EXPECT_THROW(build({{kNan, 0, 0}, {0, kNan, 0}}), IoError);
  EXPECT_THROW(build({}), IoError);
}

TEST(CloudBuilder, NormalsAreUnitOrNone) {
  PointTable table;
  table.has_normals = true;
  const double planar = 1;
  const Cloud cloud = build({{0, 0, 1, 0, 0, -2, planar},
                             {0, 0, 1, 0, 0, 0, planar},
                             {0, 0, 1, kNan, 0, 1, planar},
                             {0, 0, 1, 1e200, 1e200, 0, planar},
                             {0, 0, 1, 1, 0, 0, 2},
                             {0, 0, 1, 1, 0, 0, 0}},
                            table)
                          .cloud;
  using enum Structure;
  EXPECT_EQ(cloud.structures, (std::vector<Structure>{Planar, None, None, None, Edge, None}));
  EXPECT_EQ(cloud.directions[0], Vec3f(0, 0, -1));
  EXPECT_EQ(cloud.directions[1], Vec3f::Zero());
  EXPECT_EQ(cloud.directions[5], Vec3f::Zero());
}

TEST(CloudBuilder, NormalsTurnToTheViewpointTangentsDoNot) {
  PointTable table;
  table.has_normals = true;
  table.viewpoint = Vec3d(0, 0, 5);
  const Cloud cloud = build({{0, 0, 1, 0, 0, -1, 1}, {0, 0, 9, 0, 0, -1, 1}, {0, 0, 1, 0, 0, -1, 2}}, table).cloud;
  EXPECT_EQ(cloud.directions, (std::vector<Vec3f>{{0, 0, 1}, {0, 0, -1}, {0, 0, -1}}));
}

TEST(FindColumns, KnowsBothSchemesInEitherCase) {
  const std::vector<std::string> names{"intensity", "X", "Y", "Z", "normal_x", "normal_y", "normal_z"};
  const PointColumns columns = find_columns("file", names);
  EXPECT_EQ(columns.of_role[0], 1u);
  EXPECT_EQ(columns.of_role[5], 6u);
  EXPECT_TRUE(columns.has_normals());
  EXPECT_EQ(columns.of_role[7], 0u);
}

// Other columns may be called what they like, and CloudCompare writes an intensity under both names.
TEST(FindColumns, TheFirstIntensityCounts) {
  using Names = std::vector<std::string>;
  EXPECT_EQ(find_columns("file", Names{"x", "y", "z", "scalar_Intensity", "Intensity"}).of_role[7], 3u);
  EXPECT_FALSE(find_columns("file", Names{"x", "y", "z", "reflectivity"}).has_intensities());
}

TEST(CloudBuilder, IntensitiesAreKeptAndUnknownWhereNotFinite) {
  PointTable table;
  table.has_intensities = true;
  const double huge = std::numeric_limits<double>::max();
  const Cloud cloud =
      build({{0, 0, 1, 0, 0, 0, 1, 7.5}, {kNan, 0, 1, 0, 0, 0, 1, 8}, {0, 1, 1, 0, 0, 0, 1, huge}}, table).cloud;
  ASSERT_EQ(cloud.intensities.size(), 2u);
  EXPECT_EQ(cloud.intensities[0], 7.5f);
  EXPECT_TRUE(std::isnan(cloud.intensities[1]));
}

// robustness 3
TEST(FindColumns, MissingCoordinatesAndDoubledNamesAreErrors) {
  using Names = std::vector<std::string>;
  for (const Names& names : {Names{}, Names{"x", "y"}, Names{"x", "y", "z", "x"}, Names{"x", "y", "z", "X"},
                             Names{"x", "y", "z", "nx", "ny", "nz", "normal_x"}})
    EXPECT_THROW(find_columns("file", names), IoError);
  EXPECT_FALSE(find_columns("file", Names{"x", "y", "z", "nx", "ny"}).has_normals());
}

}  // namespace
}  // namespace augicp
