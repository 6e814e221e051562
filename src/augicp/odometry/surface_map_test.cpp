// SPDX-License-Identifier: MIT
#include "augicp/odometry/surface_map.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <stdexcept>
#include <vector>

#include "augicp/geometry/rotation.h"

namespace augicp {
namespace {

SurfaceMapOptions voxels_of(double size) {
  SurfaceMapOptions options;
  options.voxel_size = size;
  return options;
}

// z = 0.3 with a centimetre of noise, from -3 to 3 m.
Cloud noisy_plane(std::size_t count, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<float> place(-3.0f, 3.0f);
  std::normal_distribution<float> noise(0.3f, 0.01f);
  Cloud cloud;
  for (std::size_t i = 0; i < count; ++i) {
    const float x = place(random), y = place(random);
    cloud.points.emplace_back(x, y, noise(random));
  }
  return cloud;
}

Cloud vertical_line(float x, int count) {
  Cloud cloud;
  for (int i = 0; i < count; ++i)
    cloud.points.emplace_back(x, 0.2f, 0.9f * static_cast<float>(i) / static_cast<float>(count) + 0.05f);
  return cloud;
}

TEST(SurfaceMap, PointsOfAPlaneLieOnItWithItsNormal) {
  SurfaceMap map(voxels_of(1.0));
  map.add(noisy_plane(5000, 1), Rigid3{});
  const Cloud surfaces = map.surfaces(Vec3d(0.5, 0.5, 0.0));
  ASSERT_EQ(surfaces.size(), 36u);
  EXPECT_EQ(surfaces.origin, Vec3d(0.5, 0.5, 0.0));
  for (std::size_t i = 0; i < surfaces.size(); ++i) {
    EXPECT_EQ(surfaces.structures[i], Structure::Planar);
    EXPECT_GT(std::abs(surfaces.directions[i].z()), 0.999f);
    EXPECT_NEAR(surfaces.points[i].z(), 0.3f, 0.005f);
  }
}

TEST(SurfaceMap, ScansMeetWhereTheirPosesPutThem) {
  const Rigid3 map_from_scan{rotation_exp({0.3, -0.2, 1.0}), {40.0, -7.0, 2.0}};
  SurfaceMap direct(voxels_of(0.5)), moved(voxels_of(0.5));
  const Cloud plane = noisy_plane(4000, 2);
  direct.add(plane, Rigid3{});
  moved.add(transform(plane, map_from_scan), inverse(map_from_scan));
  const Cloud a = direct.surfaces(Vec3d::Zero()), b = moved.surfaces(Vec3d::Zero());
  ASSERT_GT(a.size(), 100u);
  EXPECT_NEAR(static_cast<double>(a.size()), static_cast<double>(b.size()), 2.0);
}

// Four points a square metre are too few for voxels of a metre; together with their neighbours they show the plane.
TEST(SurfaceMap, SparsePlanesAreThoseOfCoarserVoxels) {
  SurfaceMap map(voxels_of(1.0));
  map.add(noisy_plane(144, 3), Rigid3{});
  const Cloud surfaces = map.surfaces(Vec3d::Zero());
  ASSERT_GT(surfaces.size(), 20u);
  for (std::size_t i = 0; i < surfaces.size(); ++i) {
    EXPECT_GT(std::abs(surfaces.directions[i].z()), 0.99f);
    EXPECT_NEAR(surfaces.points[i].z(), 0.3f, 0.02f);
  }
}

TEST(SurfaceMap, ALineIsAnEdgeOnlyAfterSeveralScans) {
  SurfaceMap map(voxels_of(1.0));
  for (int scan = 0; scan < 3; ++scan) {
    EXPECT_TRUE(map.surfaces(Vec3d::Zero()).empty());
    map.add(vertical_line(0.4f, 20), Rigid3{});
  }
  const Cloud surfaces = map.surfaces(Vec3d::Zero());
  ASSERT_EQ(surfaces.size(), 1u);
  EXPECT_EQ(surfaces.structures[0], Structure::Edge);
  EXPECT_GT(std::abs(surfaces.directions[0].z()), 0.999f);
}

// Rings of a sensor at zero around a corner: the wall x = 8.2 m that ends at y = 0, and the wall y = 0 behind it.
Cloud rings_around_a_corner(const std::vector<double>& elevations_rad) {
  Cloud cloud;
  for (const double elevation : elevations_rad)
    for (int k = -20; k <= 20; ++k) {
      const double s = 0.02 * k;
      const Vec3d ahead = k < 0 ? Vec3d(8.2, s, 0.0) : Vec3d(8.2 + s, 0.0, 0.0);
      const Vec3d offset(0.2, 0.5, 0.2);
      const Vec3d p = ahead + offset;
      cloud.points.push_back(Vec3d(p.x(), p.y(), std::tan(elevation) * p.head<2>().norm()).cast<float>());
    }
  return cloud;
}

TEST(SurfaceMap, OneRingAroundACornerIsNoPlane) {
  SurfaceMap one(voxels_of(1.0));
  one.add(rings_around_a_corner({0.06}), Rigid3{});
  EXPECT_TRUE(one.surfaces(Vec3d::Zero()).empty());
  for (int scan = 0; scan < 5; ++scan) one.add(rings_around_a_corner({0.06}), Rigid3{});
  EXPECT_TRUE(one.surfaces(Vec3d::Zero()).empty());
}

// Rings 0.3 m apart on a floor are lines in voxels of 0.2 m. Coarser ones show the plane.
TEST(SurfaceMap, RingsOnAFloorDescribeItsPlane) {
  Cloud floor;
  for (const double distance : {3.7, 4.0, 4.3, 4.6})
    for (int k = -40; k <= 40; ++k) {
      const double azimuth = 0.02 * k / distance, height = -1.05 + 0.002 * (k % 3);  // rough by some millimetres
      floor.points.push_back(Vec3d(distance * std::cos(azimuth), distance * std::sin(azimuth), height).cast<float>());
    }
  SurfaceMap map(voxels_of(0.2));
  map.add(floor, Rigid3{});
  Cloud described = floor;
  map.describe(described, Rigid3{});
  std::size_t num_level = 0;
  for (std::size_t i = 0; i < floor.size(); ++i)
    if (described.structures[i] == Structure::Planar && std::abs(described.directions[i].z()) > 0.99f) ++num_level;
  EXPECT_EQ(std::count(described.structures.begin(), described.structures.end(), Structure::Planar),
            static_cast<std::ptrdiff_t>(num_level));
  EXPECT_GT(num_level, 0u);
}

TEST(SurfaceMap, ForgetsWhatIsFarAndKeepsTheRest) {
  SurfaceMap map(voxels_of(1.0));
  map.add(noisy_plane(5000, 1), Rigid3{});
  map.add(noisy_plane(5000, 2), {Eigen::Quaterniond::Identity(), {100.0, 0.0, 0.0}});
  map.forget_beyond(Vec3d(100.0, 0.0, 0.0), 20.0);
  EXPECT_EQ(map.num_voxels(), 36u);
  map.add(noisy_plane(5000, 3), {Eigen::Quaterniond::Identity(), {100.0, 0.0, 0.0}});
  EXPECT_EQ(map.num_voxels(), 36u);
}

TEST(SurfaceMap, IntensitiesAreAveragedWhereTheyAreKnown) {
  Cloud left = noisy_plane(5000, 1);
  left.intensities.resize(left.size());
  for (std::size_t i = 0; i < left.size(); ++i)
    left.intensities[i] = left.points[i].x() < 0.0f ? std::numeric_limits<float>::quiet_NaN()
                          : i % 2 == 0              ? 0.2f
                                                    : 0.4f;
  SurfaceMap map(voxels_of(1.0));
  map.add(left, Rigid3{});
  const Cloud surfaces = map.surfaces(Vec3d::Zero());
  ASSERT_TRUE(surfaces.has_intensities());
  for (std::size_t i = 0; i < surfaces.size(); ++i) {
    const float intensity = surfaces.intensities[i];
    EXPECT_TRUE(surfaces.points[i].x() < 0.0f ? std::isnan(intensity) : std::abs(intensity - 0.3f) < 0.03f)
        << intensity;
  }
  SurfaceMap bare(voxels_of(1.0));
  bare.add(noisy_plane(5000, 1), Rigid3{});
  EXPECT_TRUE(bare.surfaces(Vec3d::Zero()).intensities.empty());
}

TEST(SurfaceMap, ForgetsTheVoxelsOfPlaces) {
  SurfaceMap map(voxels_of(1.0)), rest(voxels_of(1.0));
  const Cloud plane = noisy_plane(5000, 1);
  map.add(plane, Rigid3{});
  Cloud others;
  for (const Vec3f& point : plane.points)
    if (point.x() < 0.0f || point.x() >= 1.0f || point.y() < 0.0f || point.y() >= 1.0f) others.points.push_back(point);
  rest.add(others, Rigid3{});
  map.forget_at({{0.1, 0.9, 0.2}, {0.5, 0.5, 0.9}, {50.0, 0.0, 0.0}, {1e30, 0.0, 0.0}});
  EXPECT_EQ(map.num_voxels(), 35u);
  const Cloud kept = map.surfaces(Vec3d::Zero()), expected = rest.surfaces(Vec3d::Zero());
  EXPECT_EQ(kept.points, expected.points);
  EXPECT_EQ(kept.directions, expected.directions);
}

TEST(SurfaceMap, DoesNotGrowWithScansOfTheSamePlace) {
  SurfaceMap map(voxels_of(1.0));
  for (unsigned scan = 0; scan < 50; ++scan) map.add(noisy_plane(2000, scan), Rigid3{});
  EXPECT_EQ(map.num_voxels(), 36u);
}

TEST(SurfaceMap, DescribesPointsByTheirVoxels) {
  SurfaceMap map(voxels_of(1.0));
  map.add(noisy_plane(5000, 1), Rigid3{});
  const Rigid3 map_from_cloud{rotation_exp({0.0, 1.0, 0.0}), {0.5, 0.5, 0.5}};
  Cloud cloud;
  cloud.points = {Vec3f::Zero(), {0.0f, 0.0f, 50.0f}};
  map.describe(cloud, map_from_cloud);
  EXPECT_EQ(cloud.structures[0], Structure::Planar);
  const Vec3f expected = (map_from_cloud.rotation.conjugate() * Vec3d::UnitZ()).cast<float>();
  EXPECT_GT(std::abs(cloud.directions[0].dot(expected)), 0.999f);
  EXPECT_EQ(cloud.structures[1], Structure::None);
}

TEST(SurfaceMap, IgnoresPointsBeyondItsGridAndRefusesOddOptions) {
  SurfaceMap map(voxels_of(0.01));
  Cloud cloud;
  cloud.points = {{3e4f, 0.0f, 0.0f}};
  map.add(cloud, Rigid3{});
  EXPECT_EQ(map.num_voxels(), 0u);
  EXPECT_THROW(SurfaceMap(voxels_of(0.0)), std::invalid_argument);
}

}  // namespace
}  // namespace augicp
