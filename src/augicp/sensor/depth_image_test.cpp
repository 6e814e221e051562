// SPDX-License-Identifier: MIT
#include "augicp/sensor/depth_image.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "augicp/testing/matchers.h"

namespace augicp {
namespace {

constexpr Pinhole kTinyCamera{500.0, 400.0, 1.5, 1.0};
const float kNaN = std::nanf("");

TEST(DepthImage, PointsProjectBackToTheirPixels) {
  const DepthImage image{3, 2, {1.0f, 2.0f, kNaN, 0.0f, 3.0f, 0.5f}};
  const OrganizedCloud seen = unproject(image, kTinyCamera);
  ASSERT_EQ(seen.cloud.size(), 4u);
  for (int v = 0; v < 2; ++v) {
    for (int u = 0; u < 3; ++u) {
      const std::int32_t i = seen.index.at(u, v);
      if (i == IndexImage::kNone) continue;
      const Vec3d p = seen.cloud.points[i].cast<double>();
      EXPECT_NEAR(kTinyCamera.fx * p.x() / p.z() + kTinyCamera.cx, u, 1e-4);
      EXPECT_NEAR(kTinyCamera.fy * p.y() / p.z() + kTinyCamera.cy, v, 1e-4);
      EXPECT_EQ(seen.cloud.points[i].z(), image.at(u, v));
    }
  }
}

TEST(DepthImage, ReadingsThatAreNoneAreLeftOut) {
  const DepthImage image{3, 1, {kNaN, 0.0f, -1.0f}};
  const OrganizedCloud seen = unproject(image, kTinyCamera);
  EXPECT_TRUE(seen.cloud.empty());
  EXPECT_EQ(seen.index.index, std::vector<std::int32_t>(3, IndexImage::kNone));
  EXPECT_EQ(unproject({1, 1, {INFINITY}}, kTinyCamera).cloud.size(), 0u);
}

TEST(DepthImage, RangeKeepsWhatIsInside) {
  const DepthImage image{3, 1, {0.4f, 1.0f, 5.0f}};
  const OrganizedCloud seen = unproject(image, kTinyCamera, {0.5, 4.5});
  ASSERT_EQ(seen.cloud.size(), 1u);
  EXPECT_EQ(seen.cloud.points[0].z(), 1.0f);
}

TEST(DepthImage, WrongSizesAreRefused) {
  Pinhole vga = kTinyCamera;
  vga.width = 640;
  vga.height = 480;
  EXPECT_THROW(unproject({1, 1, {1.0f}}, vga), std::invalid_argument);
  EXPECT_THROW(unproject({2, 2, {1.0f}}, kTinyCamera), std::invalid_argument);
  EXPECT_NO_THROW(unproject({0, 0, {}}, kTinyCamera));
}

TEST(DepthImage, ValuesAreDividedByTheScale) {
  const std::vector<std::uint16_t> values{0, 5000, 65535, 1};
  const DepthImage image = depth_image(values, 2, 2, 5000.0);
  EXPECT_EQ(image.at(1, 0), 1.0f);
  EXPECT_EQ(image.at(1, 1), static_cast<float>(1 / 5000.0));
  EXPECT_TRUE(std::isnan(image.at(0, 0)) && std::isnan(image.at(0, 1)));
  const DepthImage with_fractions = depth_image(std::vector<float>{1500.0f, 0.0f, -1.0f, INFINITY}, 4, 1, 1000.0);
  EXPECT_EQ(with_fractions.at(0, 0), 1.5f);
  for (int u = 1; u < 4; ++u) EXPECT_TRUE(std::isnan(with_fractions.at(u, 0))) << u;
  EXPECT_THROW(depth_image(values, 2, 2, 0.0), std::invalid_argument);
  EXPECT_THROW(depth_image(values, 2, 1, 5000.0), std::invalid_argument);
}

}  // namespace
}  // namespace augicp
