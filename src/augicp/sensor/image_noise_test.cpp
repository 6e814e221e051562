// SPDX-License-Identifier: MIT
#include "augicp/sensor/image_noise.h"

#include <gtest/gtest.h>

#include "augicp/testing/rendering.h"
#include "augicp/testing/scenes.h"

namespace augicp {
namespace {

constexpr int kColumns = 160;

Scan seen(const testing::Scene& scene, double noise, unsigned seed) {
  const Pinhole camera = testing::kinect_like_camera(kColumns);
  DepthImage image = testing::render(scene, camera).depth;
  if (noise > 0.0) testing::add_depth_noise(image, noise, seed);
  return scan_of(image, camera);
}

TEST(ImageNoise, IsThatOfTheCamera) {
  for (const double noise : {0.0012, 0.0024, 0.0048})
    for (const unsigned seed : {1u, 2u, 3u})
      EXPECT_NEAR(noise_per_depth_sq(seen(testing::room(seed), noise, seed)), noise, 0.15 * noise);
}

TEST(ImageNoise, SurfacesHaveNone) {
  for (const auto& scene : {testing::single_plane(), testing::corridor(), testing::room()})
    EXPECT_LT(noise_per_depth_sq(seen(scene, 0.0, 1)), 2e-4);
}

TEST(ImageNoise, TooFewReadingsShowNone) {
  const Pinhole camera{10.0, 10.0, 1.0, 0.0, 3, 1};
  const float none = std::numeric_limits<float>::quiet_NaN();
  EXPECT_EQ(noise_per_depth_sq(scan_of(DepthImage{3, 1, {none, none, none}}, camera)), 0.0);
  EXPECT_EQ(noise_per_depth_sq(scan_of(DepthImage{3, 1, {1.0f, none, 2.0f}}, camera)), 0.0);
  EXPECT_GT(noise_per_depth_sq(scan_of(DepthImage{3, 1, {1.0f, 1.1f, 1.0f}}, camera)), 0.0);
}

}  // namespace
}  // namespace augicp
