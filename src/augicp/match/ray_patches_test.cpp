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

TEST(RayPatches, FewPointsHaveNone) {
  EXPECT_TRUE(ray_patches(Cloud(), Vec3f::Zero()).empty());
  EXPECT_TRUE(ray_patches(seen_along_z(3, 1.0f), Vec3f::Zero()).empty());
}

}  // namespace
}  // namespace augicp
