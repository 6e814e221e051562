// SPDX-License-Identifier: MIT
#include "augicp/sensor/grey_image.h"

#include <gtest/gtest.h>

#include <cmath>

#include "augicp/sensor/depth_camera.h"

namespace augicp {
namespace {

GreyImage ramp(int width, int height) {
  GreyImage image{width, height, {}};
  for (int pixel = 0; pixel < width * height; ++pixel) image.value.push_back(static_cast<float>(pixel) / 1e4f);
  return image;
}

TEST(GreyImage, EveryPointHasTheBrightnessOfItsPixel) {
  Cloud cloud;
  cloud.points = {Vec3f::UnitX(), Vec3f::UnitY(), Vec3f::UnitZ()};
  IndexImage seen(3, 2);
  seen.index = {IndexImage::kNone, 1, 0, IndexImage::kNone, IndexImage::kNone, IndexImage::kNone};
  add_intensities(cloud, seen, ramp(3, 2));
  EXPECT_EQ(cloud.intensities[0], ramp(3, 2).at(2, 0));
  EXPECT_EQ(cloud.intensities[1], ramp(3, 2).at(1, 0));
  EXPECT_TRUE(std::isnan(cloud.intensities[2]));  // seen in no pixel
}

TEST(GreyImage, ImagesOfAnotherSizeAreRefused) {
  Cloud cloud;
  EXPECT_THROW(add_intensities(cloud, IndexImage(3, 2), ramp(2, 3)), std::invalid_argument);
  EXPECT_THROW(add_intensities(cloud, IndexImage(3, 2), {3, 2, {}}), std::invalid_argument);
  EXPECT_THROW(rectify(ramp(3, 2), *camera_by_name("tum-fr1")), std::invalid_argument);
  EXPECT_THROW(rectify(GreyImage{640, 480, {}}, *camera_by_name("tum-fr1")), std::invalid_argument);
}

// A lens distorts both images alike: brightness comes from the pixel that the depth comes from.
TEST(GreyImage, IsRectifiedAsTheDepthImageIs) {
  const DepthCamera camera = *camera_by_name("tum-fr1");
  const GreyImage grey = ramp(640, 480);
  for (const int step : {1, 2}) {
    const DepthImage depth = rectify(DepthImage{640, 480, grey.value}, camera, step);
    const GreyImage straight = rectify(grey, camera, step);
    ASSERT_EQ(straight.value.size(), depth.depth.size());
    EXPECT_EQ(straight.width, depth.width);
    for (std::size_t pixel = 0; pixel < depth.depth.size(); ++pixel)
      if (!std::isnan(depth.depth[pixel])) {
        ASSERT_EQ(straight.value[pixel], depth.depth[pixel]);
      }
  }
}

}  // namespace
}  // namespace augicp
