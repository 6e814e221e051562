// SPDX-License-Identifier: MIT
#include "augicp/match/ray_spacing.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

namespace augicp {
namespace {

constexpr float kLineStep = 0.01f;  // radians between the rays of a line

// What lies along a ray: walls 3 m away on all sides, and a block that hides a part of them.
float range_along(const Vec3f& ray) {
  const bool meets_block = std::abs(ray.y()) < 0.3f * ray.x() && std::abs(ray.z()) < 0.2f * ray.x();
  return (meets_block ? 1.2f : 3.0f) / ray.cwiseAbs().maxCoeff();
}

constexpr float kSpacingTolerance = 0.1f;  // metres

// Lines at even elevations, rays at even azimuths; range noise is along the ray and leaves its direction. The lines of
// many sensors are not in step: each begins at an azimuth of its own.
Cloud spun_scan(unsigned seed, bool in_step = true) {
  std::mt19937 generator(seed);
  std::normal_distribution<float> noise(0.0f, 0.02f);
  std::uniform_real_distribution<float> phase(0.0f, kLineStep);
  Cloud scan;
  for (int line = -8; line < 8; ++line)
    for (float azimuth = in_step ? 0.0f : phase(generator); azimuth < 2.0f * std::numbers::pi_v<float>;
         azimuth += kLineStep) {
      const float elevation = 3.5f * kLineStep * static_cast<float>(line);
      const Vec3f ray(std::cos(elevation) * std::cos(azimuth), std::cos(elevation) * std::sin(azimuth),
                      std::sin(elevation));
      const float range = range_along(ray) + noise(generator);
      scan.points.push_back(range * ray);
    }
  return scan;
}

// Points spread at random over the walls of a long hall, as many on each square metre: a model, not a scan.
Cloud model_of_a_hall(unsigned seed) {
  std::mt19937 generator(seed);
  std::uniform_real_distribution<float> along(-30.0f, 30.0f), across(-2.0f, 2.0f);
  Cloud model;
  for (int k = 0; k < 60000; ++k) {
    const float side = k % 2 == 0 ? 2.0f : -2.0f;
    model.points.push_back(k % 4 < 2 ? Vec3f(along(generator), side, across(generator))
                                     : Vec3f(along(generator), across(generator), side));
  }
  return model;
}

Cloud joined(Cloud one, const Cloud& other) {
  one.points.insert(one.points.end(), other.points.begin(), other.points.end());
  return one;
}

double evenness_from(const Cloud& cloud, const Vec3f& place) { return evenness(ray_patches(cloud, place)); }

TEST(RaySpacing, RaysOfASensorAreEvenInAndOutOfStep) {
  EXPECT_GT(evenness_from(spun_scan(1), Vec3f::Zero()), 0.95);
  EXPECT_GT(evenness_from(spun_scan(1, false), Vec3f::Zero()), 0.95);
  EXPECT_TRUE(is_one_sensors_scan(spun_scan(2), kSpacingTolerance));
  EXPECT_TRUE(is_one_sensors_scan(spun_scan(2, false), kSpacingTolerance));
}

// The law of the nearest neighbour in the plane: P(d < r) = 1 - exp(-pi n r^2), so that the ratio of the quantiles p
// and q is sqrt(ln(1 - p) / ln(1 - q)).
TEST(RaySpacing, RandomDirectionsHaveTheRatioOfAPoissonProcess) {
  std::mt19937 generator(3);
  std::normal_distribution<float> normal;
  Cloud cloud;
  for (int k = 0; k < 100000; ++k)
    cloud.points.push_back(Vec3f(normal(generator), normal(generator), normal(generator)));
  EXPECT_NEAR(evenness_from(cloud, Vec3f::Zero()), std::sqrt(std::log(0.98) / std::log(0.8)), 0.06);
  EXPECT_FALSE(is_one_sensors_scan(cloud, kSpacingTolerance));
}

// As many points on each square metre: the angle between two is their distance by the range.
TEST(RaySpacing, GrowsWithTheRangeOnlyOnModels) {
  const auto of_scan = growth_with_range(ray_patches(spun_scan(8), Vec3f::Zero()));
  ASSERT_TRUE(of_scan);
  EXPECT_NEAR(*of_scan, 0.0, 0.05);
  Cloud sphere = spun_scan(9);
  for (Vec3f& point : sphere.points) point.normalize();
  EXPECT_FALSE(growth_with_range(ray_patches(sphere, Vec3f::Zero())));
  // Across the line of sight. A slanted surface has still closer directions: the exponent is -1 to -1.5.
  const auto of_model = growth_with_range(ray_patches(model_of_a_hall(10), Vec3f::Zero()));
  ASSERT_TRUE(of_model);
  EXPECT_NEAR(*of_model, -1.25, 0.3);
  EXPECT_FALSE(is_one_sensors_scan(model_of_a_hall(10), kSpacingTolerance));
}

// Directions at random between walls, with a pillar in front of each.
Cloud seen_among_pillars(unsigned seed) {
  std::mt19937 generator(seed);
  std::normal_distribution<float> normal;
  Cloud scan;
  for (int k = 0; k < 60000; ++k) {
    const Vec3f ray = Vec3f(normal(generator), normal(generator), normal(generator)).normalized();
    const bool meets_pillar = std::min(std::abs(ray.x()), std::abs(ray.y())) < 0.15f;
    scan.points.push_back((meets_pillar ? 1.5f : 4.0f) / ray.cwiseAbs().maxCoeff() * ray);
  }
  return scan;
}

// Lines that nearly meet: directions are as good as random, but from the sensor's place nothing lies behind anything.
TEST(RaySpacing, ScansWhoseLinesMeetAreKnownAsNothingLiesBehindAnything) {
  Cloud scan = seen_among_pillars(11);
  EXPECT_LT(evenness_from(scan, Vec3f::Zero()), 0.5);
  EXPECT_TRUE(is_one_sensors_scan(scan, kSpacingTolerance));
  scan.viewpoint = Vec3f(0.7f, 0.7f, 0.0f);
  EXPECT_FALSE(is_one_sensors_scan(scan, kSpacingTolerance));
}

TEST(RaySpacing, TwoScansInOneFrameAreNotOneSensors) {
  Cloud second = spun_scan(4);
  for (Vec3f& point : second.points) point += Vec3f(0.8f, -0.5f, 0.1f);
  EXPECT_LT(evenness_from(joined(spun_scan(5), second), Vec3f::Zero()), 0.7);
}

TEST(RaySpacing, FromAnotherPlaceRaysAreLessEven) {
  const Cloud scan = spun_scan(6);
  EXPECT_LT(evenness_from(scan, Vec3f(1.0f, 0.0f, 0.0f)), 0.7 * evenness_from(scan, Vec3f::Zero()));
}

// The viewpoint, else the zero of the frame, whatever the origin of the points.
TEST(RaySpacing, ThePlaceFollowsViewpointAndOrigin) {
  Cloud scan = spun_scan(7);
  const Vec3f away(5.0f, 4.0f, 0.0f);
  for (Vec3f& point : scan.points) point += away;
  EXPECT_FALSE(is_one_sensors_scan(scan, kSpacingTolerance));
  scan.viewpoint = away;
  EXPECT_TRUE(is_one_sensors_scan(scan, kSpacingTolerance));
  scan.viewpoint.reset();
  scan.origin = -away.cast<double>();
  EXPECT_TRUE(is_one_sensors_scan(scan, kSpacingTolerance));
}

TEST(RaySpacing, NoPointsAndOnePlaceAreNoScan) {
  Cloud cloud;
  EXPECT_EQ(evenness_from(cloud, Vec3f::Zero()), 0.0);
  cloud.points.assign(100, Vec3f(1.0f, 2.0f, 3.0f));
  EXPECT_EQ(evenness_from(cloud, Vec3f::Zero()), 0.0);
  EXPECT_EQ(evenness_from(cloud, Vec3f(1.0f, 2.0f, 3.0f)), 0.0);
}

}  // namespace
}  // namespace augicp
