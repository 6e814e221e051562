// SPDX-License-Identifier: MIT
#include "augicp/match/ray_patches.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace augicp {
namespace {

constexpr float kStep = 0.004f;  // radians

// A sensor that looks along z, with rays a step apart.
Cloud seen_along_z(int rays_per_side, float range) {
  Cloud cloud;
  for (int u = 0; u < rays_per_side; ++u)
    for (int v = 0; v < rays_per_side; ++v) {
      const float x = kStep * static_cast<float>(u - rays_per_side / 2);
      const float y = kStep * static_cast<float>(v - rays_per_side / 2);
      cloud.points.push_back(range * Vec3f(x, y, 1.0f).normalized());
    }
  return cloud;
}

std::size_t num_rays(const std::vector<RayPatch>& patches) {
  std::size_t sum = 0;
  for (const RayPatch& patch : patches) sum += patch.rays.size();
  return sum;
}

TEST(RayPatches, SpacingIsTheSensorsStepWhateverTheRange) {
  for (const float range : {1.0f, 40.0f}) {
    const std::vector<RayPatch> patches = ray_patches(seen_along_z(60, range), Vec3f::Zero());
    ASSERT_FALSE(patches.empty());
    for (const RayPatch& patch : patches)
      for (const float angle : patch.spacing) EXPECT_NEAR(angle, kStep, 0.05f * kStep);
  }
}

// Thinned by whole patches: few of the points, at the spacing of all.
TEST(RayPatches, LargeScansAreSampledByWholePatches) {
  const Cloud scan = seen_along_z(300, 5.0f);
  const std::vector<RayPatch> patches = ray_patches(scan, Vec3f::Zero());
  EXPECT_LT(num_rays(patches), scan.size() / 4);
  EXPECT_GT(num_rays(patches), 4000U);
  for (const RayPatch& patch : patches)
    EXPECT_LT(*std::max_element(patch.spacing.begin(), patch.spacing.end()), 1.1f * kStep);
}

TEST(RayPatches, RaysBeginAtThePlace) {
  const Vec3f place(1.0f, -2.0f, 0.5f);
  Cloud scan = seen_along_z(40, 3.0f);
  for (Vec3f& point : scan.points) point += place;
  scan.points.push_back(place);  // has no direction
  const std::vector<RayPatch> patches = ray_patches(scan, place);
  ASSERT_FALSE(patches.empty());
  for (const RayPatch& patch : patches) {
    ASSERT_EQ(patch.spacing.size(), patch.rays.size());
    for (const Vec3f& ray : patch.rays) EXPECT_NEAR(ray.norm(), 3.0f, 1e-5f);
  }
}

// All points of a distant object lie in one patch: each with each would take hours.
TEST(RayPatches, TheCostOfADistantCloudGrowsAsItsPointsDo) {
  constexpr int kSide = 600;
  Cloud cloud;
  for (int u = 0; u < kSide; ++u)
    for (int v = 0; v < kSide; ++v)
      cloud.points.emplace_back(500.0f, 2.0f + 0.003f * static_cast<float>(u), 2.0f + 0.003f * static_cast<float>(v));
  const std::vector<RayPatch> patches = ray_patches(cloud, Vec3f::Zero());
  ASSERT_EQ(patches.size(), 1U);
  EXPECT_EQ(patches[0].rays.size(), cloud.size());
  EXPECT_GE(patches[0].spacing.size(), 64U);
  EXPECT_LT(patches[0].spacing.size(), 1000U);
  for (const float angle : patches[0].spacing) EXPECT_NEAR(angle, 0.003f / 500.0f, 0.1f * 0.003f / 500.0f);
}

// Most rays of a full patch have one spacing, and so have those that are measured: they come from all over it.
TEST(RayPatches, AFullPatchIsMeasuredAllOver) {
  Cloud cloud;
  for (const float step : {0.0002f, 0.0004f})
    for (int u = 0; u < 3000; ++u)
      cloud.points.emplace_back(100.0f, 0.2f + step * static_cast<float>(u), step == 0.0002f ? 0.2f : 0.4f);
  const std::vector<RayPatch> patches = ray_patches(cloud, Vec3f::Zero());
  for (const RayPatch& patch : patches) {
    const auto num_fine = std::count_if(patch.spacing.begin(), patch.spacing.end(), [](float x) { return x < 3e-6f; });
    EXPECT_LT(patch.spacing.size(), patch.rays.size());
    EXPECT_NEAR(static_cast<double>(num_fine) / static_cast<double>(patch.spacing.size()), 0.5, 0.1);
  }
}

TEST(RayPatches, FewPointsHaveNone) {
  EXPECT_TRUE(ray_patches(Cloud(), Vec3f::Zero()).empty());
  EXPECT_TRUE(ray_patches(seen_along_z(3, 1.0f), Vec3f::Zero()).empty());
}

}  // namespace
}  // namespace augicp
