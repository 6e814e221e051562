// SPDX-License-Identifier: MIT
#include "augicp/odometry/map_archive.h"

#include <gtest/gtest.h>

#include <limits>

namespace augicp {
namespace {

Cloud level_points(const std::vector<Vec3f>& points, float intensity) {
  Cloud cloud;
  cloud.points = points;
  cloud.directions.assign(points.size(), Vec3f::UnitZ());
  cloud.structures.assign(points.size(), Structure::Planar);
  cloud.intensities.assign(points.size(), intensity);
  return cloud;
}

Cloud all_of(const MapArchive& archive) { return archive.tiles(std::numeric_limits<double>::infinity()).at({0, 0}); }

TEST(MapArchive, KeepsWhatTheOdometryForgets) {
  MapArchive archive(1.0, 20.0);
  EXPECT_TRUE(archive.is_due(Vec3d::Zero()));
  archive.update(level_points({{1.5f, 0.0f, 0.0f}, {8.5f, 0.0f, 0.0f}}, 0.25f), Vec3d::Zero());
  EXPECT_FALSE(archive.is_due(Vec3d(4.9, 0.0, 0.0)));
  EXPECT_TRUE(archive.is_due(Vec3d(5.1, 0.0, 0.0)));
  archive.update(level_points({{40.5f, 0.0f, 0.0f}}, 0.5f), Vec3d(40.0, 0.0, 0.0));
  const Cloud all = all_of(archive);
  ASSERT_EQ(all.size(), 3u);
  EXPECT_EQ(all.points[0], Vec3f(1.5f, 0.0f, 0.0f));
  EXPECT_EQ(all.directions[2], Vec3f(Vec3f::UnitZ()));
  EXPECT_EQ(all.intensities[2], 0.5f);
}

// Near the sensor the new points are the better ones; far away, what was seen from nearer stays. What a local map lacks
// it may have forgotten, as where a loop closes.
TEST(MapArchive, ReplacesWhatIsNearKeepsWhatIsFarAndTakesNothingAway) {
  MapArchive archive(1.0, 20.0);
  archive.update(level_points({{1.5f, 0.0f, 0.0f}, {2.5f, 0.0f, 0.0f}, {15.5f, 0.0f, 0.0f}}, 0.1f), Vec3d::Zero());
  archive.update(level_points({{2.4f, 0.0f, 0.0f}, {15.4f, 0.0f, 0.0f}}, 0.2f), Vec3d::Zero());
  const Cloud all = all_of(archive);
  ASSERT_EQ(all.size(), 3u);
  EXPECT_EQ(all.points[0].x(), 1.5f);
  EXPECT_EQ(all.points[1].x(), 2.4f);
  EXPECT_EQ(all.points[2].x(), 15.5f);
}

TEST(MapArchive, TilesDivideTheMap) {
  MapArchive archive(1.0, 1000.0);
  archive.update(level_points({{-0.5f, 3.0f, 7.0f}, {9.5f, 9.5f, 0.0f}, {10.5f, -0.5f, 0.0f}}, 0.5f), Vec3d::Zero());
  const auto tiles = archive.tiles(10.0);
  ASSERT_EQ(tiles.size(), 3u);
  const Cloud& left = tiles.at({-1, 0});
  EXPECT_EQ(left.origin, Vec3d(-10.0, 0.0, 0.0));
  EXPECT_EQ(left.points[0], Vec3f(9.5f, 3.0f, 7.0f));
  EXPECT_EQ(tiles.at({0, 0}).points[0], Vec3f(9.5f, 9.5f, 0.0f));
  EXPECT_EQ(tiles.at({1, -1}).points[0], Vec3f(0.5f, 9.5f, 0.0f));
}

TEST(MapArchive, UnknownIntensitiesAreLeftOut) {
  MapArchive archive(1.0, 20.0);
  Cloud bare = level_points({{1.5f, 0.0f, 0.0f}}, 0.0f);
  bare.intensities.clear();
  archive.update(bare, Vec3d::Zero());
  EXPECT_FALSE(all_of(archive).has_intensities());
  EXPECT_TRUE(MapArchive(1.0, 20.0).tiles(10.0).empty());
}

}  // namespace
}  // namespace augicp
