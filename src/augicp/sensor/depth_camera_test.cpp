// SPDX-License-Identifier: MIT
#include "augicp/sensor/depth_camera.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

namespace augicp {
namespace {

// Each reading is the number of its pixel.
DepthImage numbered_image(int width, int height) {
  DepthImage image{width, height, {}};
  for (int i = 0; i < width * height; ++i) image.depth.push_back(static_cast<float>(i + 1));
  return image;
}

TEST(DepthCamera, EveryNamedOneIsUsable) {
  EXPECT_GE(camera_names().size(), 4u);
  for (const std::string& name : camera_names()) {
    const auto camera = camera_by_name(name);
    ASSERT_TRUE(camera) << name;
    EXPECT_NO_THROW(camera->check()) << name;
  }
  EXPECT_FALSE(camera_by_name("tum-fr9"));
}

TEST(DepthCamera, RefusesALensAndAShutterThatCannotBe) {
  const Pinhole pinhole{50.0, 50.0, 32.0, 24.0, 64, 48};
  EXPECT_THROW((DepthCamera{pinhole, {std::nan(""), 0, 0, 0, 0}}.check()), std::invalid_argument);
  EXPECT_THROW((DepthCamera{pinhole, {0, 0, 0, 0, 1e9}}.check()), std::invalid_argument);
  EXPECT_THROW((DepthCamera{pinhole, {}, -0.1}.check()), std::invalid_argument);
  EXPECT_THROW((DepthCamera{pinhole, {}, 2.0}.check()), std::invalid_argument);
}

TEST(Distortion, IsThePolynomialOfItsFields) {
  // By hand at (0.5, -0.25): r^2 = 0.3125.
  const Eigen::Vector2d radial = Distortion{0.1, 0.2, 0.0, 0.0, 0.4}({0.5, -0.25});
  const double factor = 1.0 + 0.1 * 0.3125 + 0.2 * 0.3125 * 0.3125 + 0.4 * 0.3125 * 0.3125 * 0.3125;
  EXPECT_NEAR(radial.x(), 0.5 * factor, 1e-15);
  EXPECT_NEAR(radial.y(), -0.25 * factor, 1e-15);
  const Eigen::Vector2d tangential = Distortion{0.0, 0.0, 0.01, 0.02, 0.0}({0.5, -0.25});
  EXPECT_NEAR(tangential.x(), 0.5 + 2 * 0.01 * 0.5 * -0.25 + 0.02 * (0.3125 + 2 * 0.25), 1e-15);
  EXPECT_NEAR(tangential.y(), -0.25 + 0.01 * (0.3125 + 2 * 0.0625) + 2 * 0.02 * 0.5 * -0.25, 1e-15);
}

TEST(Rectify, LeavesAnIdealCamerasImageAlone) {
  const DepthImage image = numbered_image(64, 48);
  EXPECT_EQ(rectify(image, {{50.0, 50.0, 31.5, 23.5, 64, 48}, {}}).depth, image.depth);
}

TEST(Rectify, TakesEveryReadingFromWhereItsRayWasSeen) {
  const DepthCamera camera{{50.0, 55.0, 31.0, 24.0, 64, 48}, {0.2, -0.1, 0.01, -0.02, 0.05}};
  const DepthImage image = numbered_image(64, 48);
  const DepthImage rectified = rectify(image, camera);
  int num_moved = 0;
  for (int v = 0; v < 48; ++v)
    for (int u = 0; u < 64; ++u) {
      const float reading = rectified.at(u, v);
      if (std::isnan(reading)) continue;
      const int from = static_cast<int>(reading) - 1;
      const Eigen::Vector2d seen = camera.distortion({(u - 31.0) / 50.0, (v - 24.0) / 55.0});
      EXPECT_LE(std::abs(50.0 * seen.x() + 31.0 - from % 64), 0.5 + 1e-9);
      EXPECT_LE(std::abs(55.0 * seen.y() + 24.0 - from / 64), 0.5 + 1e-9);
      num_moved += from != v * 64 + u;
    }
  EXPECT_GT(num_moved, 500);
}

TEST(Rectify, ThinsTheImageAndTheCameraAlike) {
  const Pinhole pinhole{50.0, 55.0, 31.0, 24.0, 65, 48};
  const Pinhole half = thinned(pinhole, 2);
  EXPECT_EQ(half.width, 32);
  EXPECT_EQ(half.height, 24);
  const DepthImage image = numbered_image(65, 48);
  const DepthImage thin = rectify(image, {pinhole, {}}, 2);
  ASSERT_EQ(thin.depth.size(), 32u * 24u);
  for (int v = 0; v < 24; ++v)
    for (int u = 0; u < 32; ++u) {
      EXPECT_EQ(thin.at(u, v), image.at(2 * u, 2 * v));
      EXPECT_NEAR((u - half.cx) / half.fx, (2 * u - pinhole.cx) / pinhole.fx, 1e-15) << "the same ray";
    }
  EXPECT_THROW(thinned(pinhole, 0), std::invalid_argument);
}

TEST(Rectify, RefusesAnImageOfAnotherSize) {
  EXPECT_THROW(rectify(numbered_image(64, 48), {{50.0, 50.0, 32.0, 24.0, 32, 24}, {}}), std::invalid_argument);
}

}  // namespace
}  // namespace augicp
