// SPDX-License-Identifier: MIT
#include "augicp/match/ray_spacing.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

namespace augicp {
namespace {

constexpr float kStep = 0.01f;  // radians between the rays of a line

// What lies along a ray: walls 3 m away on all sides, and a block that hides a part of them.
float range_along(const Vec3f& ray) {
  const bool meets_block = std::abs(ray.y()) < 0.3f * ray.x() && std::abs(ray.z()) < 0.2f * ray.x();
  return (meets_block ? 1.2f : 3.0f) / ray.cwiseAbs().maxCoeff();
}

// Lines at even elevations, rays at even azimuths; range noise is along the ray and leaves its direction.
Cloud spun_scan(unsigned seed) {
  std::mt19937 generator(seed);
  std::normal_distribution<float> noise(0.0f, 0.02f);
  Cloud scan;
  for (int line = -8; line < 8; ++line)
    for (float azimuth = 0.0f; azimuth < 2.0f * std::numbers::pi_v<float>; azimuth += kStep) {
      const float elevation = 3.5f * kStep * static_cast<float>(line);
      const Vec3f ray(std::cos(elevation) * std::cos(azimuth), std::cos(elevation) * std::sin(azimuth),
                      std::sin(elevation));
      const float range = range_along(ray) + noise(generator);
      scan.points.push_back(range * ray);
    }
  return scan;
}

Cloud joined(Cloud one, const Cloud& other) {
  one.points.insert(one.points.end(), other.points.begin(), other.points.end());
  return one;
}

TEST(RaySpacing, RaysOfASensorAreEvenAndRangeNoiseDoesNotChangeThat) {
  EXPECT_GT(evenness_of_rays(spun_scan(1), Vec3f::Zero()), 0.9);
  EXPECT_TRUE(is_one_sensors_scan(spun_scan(2)));
}

// The law of the nearest neighbour in the plane: P(d < r) = 1 - exp(-pi n r^2), so that the ratio of the quantiles q
// and 1/2 is sqrt(ln(1 - q) / ln(1/2)).
TEST(RaySpacing, RandomDirectionsHaveTheRatioOfAPoissonProcess) {
  std::mt19937 generator(3);
  std::normal_distribution<float> normal;
  Cloud cloud;
  for (int k = 0; k < 8000; ++k) cloud.points.push_back(Vec3f(normal(generator), normal(generator), normal(generator)));
  EXPECT_NEAR(evenness_of_rays(cloud, Vec3f::Zero()), std::sqrt(std::log(0.98) / std::log(0.5)), 0.03);
  EXPECT_FALSE(is_one_sensors_scan(cloud));
}

TEST(RaySpacing, TwoScansInOneFrameAreNotOneSensors) {
  Cloud second = spun_scan(4);
  for (Vec3f& point : second.points) point += Vec3f(0.8f, -0.5f, 0.1f);
  EXPECT_FALSE(is_one_sensors_scan(joined(spun_scan(5), second)));
}

TEST(RaySpacing, FromAnotherPlaceRaysAreLessEven) {
  const Cloud scan = spun_scan(6);
  EXPECT_LT(evenness_of_rays(scan, Vec3f(1.0f, 0.0f, 0.0f)), 0.7 * evenness_of_rays(scan, Vec3f::Zero()));
}

// The viewpoint, else the zero of the frame, whatever the origin of the points.
TEST(RaySpacing, ThePlaceFollowsViewpointAndOrigin) {
  Cloud scan = spun_scan(7);
  const Vec3f away(5.0f, 4.0f, 0.0f);
  for (Vec3f& point : scan.points) point += away;
  EXPECT_FALSE(is_one_sensors_scan(scan));
  scan.viewpoint = away;
  EXPECT_TRUE(is_one_sensors_scan(scan));
  scan.viewpoint.reset();
  scan.origin = -away.cast<double>();
  EXPECT_TRUE(is_one_sensors_scan(scan));
}

TEST(RaySpacing, NoPointsAndOnePlaceAreNoScan) {
  Cloud cloud;
  EXPECT_EQ(evenness_of_rays(cloud, Vec3f::Zero()), 0.0);
  cloud.points.assign(100, Vec3f(1.0f, 2.0f, 3.0f));
  EXPECT_EQ(evenness_of_rays(cloud, Vec3f::Zero()), 0.0);
  EXPECT_EQ(evenness_of_rays(cloud, Vec3f(1.0f, 2.0f, 3.0f)), 0.0);
}

}  // namespace
}  // namespace augicp
