// SPDX-License-Identifier: MIT
#include "augicp/registration/thin_scan.h"

#include <gtest/gtest.h>

#include "augicp/registration/registration.h"
#include "augicp/testing/rendering.h"
#include "augicp/testing/scenes.h"

namespace augicp {
namespace {

Scan room_image() {
  const testing::Scene room = testing::room();
  const Pinhole camera = testing::kinect_like_camera(160);
  const Scan raw = scan_of(testing::render(room, camera).depth, camera);
  return prepare(raw, lengths_for(raw, raw, {}), {});
}

TEST(Thinned, KeepsThePointsOfTheirPixelsWithAllThatBelongsToThem) {
  const Scan whole = room_image(), thin = thinned(whole, 4);
  EXPECT_EQ(thin.view->index.width, whole.view->index.width / 4);
  EXPECT_EQ(thin.view->camera.fx, whole.view->camera.fx / 4);
  std::size_t next = 0;
  for (int v = 0; v < thin.view->index.height; ++v)
    for (int u = 0; u < thin.view->index.width; ++u) {
      const std::int32_t i = thin.view->index.at(u, v), from = whole.view->index.at(4 * u, 4 * v);
      ASSERT_EQ(i == IndexImage::kNone, from == IndexImage::kNone);
      if (i == IndexImage::kNone) continue;
      ASSERT_EQ(static_cast<std::size_t>(i), next++);  // raster order
      EXPECT_EQ(thin.cloud.points[i], whole.cloud.points[from]);
      EXPECT_EQ(thin.cloud.directions[i], whole.cloud.directions[from]);
      EXPECT_EQ(thin.cloud.weights[i], whole.cloud.weights[from]);
    }
  EXPECT_EQ(next, thin.cloud.size());
  EXPECT_EQ(thinned(whole, 1).cloud.points, whole.cloud.points);
}

// A depth camera's rays are even; prepare() asks before it thins, and what is thinned later keeps the answer.
TEST(Coarser, TheSensorsPlaceStaysKnown) {
  const Scan image = room_image();
  const Lengths lengths = lengths_for(image, image, {});
  Cloud two_views = image.cloud;
  for (const Vec3f& point : image.cloud.points) two_views.points.push_back(point + Vec3f(0.37f, 0.21f, 0.11f));
  two_views.directions.clear(), two_views.structures.clear(), two_views.weights.clear();
  const Scan one = prepare(scan_of(image.cloud), lengths, {}), two = prepare(scan_of(two_views), lengths, {});
  EXPECT_TRUE(one.place_is_known);
  EXPECT_FALSE(two.place_is_known);
  EXPECT_TRUE(coarser(one, 40, 8.0, lengths).place_is_known);
  EXPECT_FALSE(coarser(two, 40, 8.0, lengths).place_is_known);
}

TEST(Coarser, CloudsLosePointsAndImagesColumns) {
  const Scan image = room_image();
  const Lengths lengths = lengths_for(image, image, {});
  EXPECT_EQ(coarser(image, 40, 8.0, lengths).view->index.width, 40);
  const Scan cloud = prepare(scan_of(image.cloud), lengths, {});
  const Scan coarse = coarser(cloud, 40, 8.0, lengths);
  EXPECT_LT(coarse.cloud.size(), cloud.cloud.size() / 8);
  EXPECT_TRUE(coarse.cloud.has_directions());
}

}  // namespace
}  // namespace augicp
