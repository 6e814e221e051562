// SPDX-License-Identifier: MIT
#include "augicp/testing/edge_truth.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>

#include "augicp/testing/matchers.h"
#include "augicp/testing/scenes.h"

namespace augicp::testing {
namespace {

constexpr double kRadius = 0.03;

double total_length(const std::vector<Crease>& creases) {
  return std::accumulate(creases.begin(), creases.end(), 0.0,
                         [](double sum, const Crease& crease) { return sum + (crease.end - crease.begin).norm(); });
}

TEST(EdgeTruth, NearestCreaseIsMeasuredToTheSegment) {
  const std::vector<Crease> creases{{{0.0, 0.0, 0.0}, {2.0, 0.0, 0.0}, 0, 1}};
  EXPECT_DOUBLE_EQ(nearest_crease(creases, {1.0, 3.0, 4.0}).distance, 5.0);
  EXPECT_DOUBLE_EQ(nearest_crease(creases, {5.0, 4.0, 0.0}).distance, 5.0);
  EXPECT_THAT(nearest_crease(creases, {1.0, 3.0, 4.0}).tangent, NearVector(Vec3d(Vec3d::UnitX()), 1e-15));
  EXPECT_TRUE(std::isinf(nearest_crease({}, {1.0, 3.0, 4.0}).distance));
}

// A box 25 cm high seen from above shows three faces: the three edges between them, the two between those and the table
// in full, and of the hidden faces' edges nothing.
TEST(EdgeTruth, OnlyEdgesWithBothFacesSeenCount) {
  const Scene scene = box_on_table();
  const Rendering seen = render(scene, kinect_like_camera(320));
  const std::vector<Crease> visible = visible_creases(scene, seen, kRadius);
  const std::set<int> surfaces(seen.surface.begin(), seen.surface.end());
  double expected_length = 0.0;
  for (const Crease& crease : scene.creases)
    if (surfaces.count(crease.first_surface) && surfaces.count(crease.second_surface))
      expected_length += (crease.end - crease.begin).norm();
  // top-front, top-side, the upright between them, front-table, side-table; each may run on by kRadius at most.
  EXPECT_NEAR(expected_length, 2 * (0.4 + 0.3) + 0.25, 1e-9);
  EXPECT_GE(total_length(visible), expected_length - 0.1);
  EXPECT_LE(total_length(visible), expected_length + 0.1);
}

TEST(EdgeTruth, CreaseOutsideTheImageIsNotVisible) {
  const Scene scene = box_on_table();
  const Rendering away = render(scene, kinect_like_camera(80), 80, 60, look_at({0.3, -1.1, 0.9}, {0.3, -9.0, 0.9}));
  EXPECT_TRUE(visible_creases(scene, away, kRadius).empty());
}

TEST(EdgeTruth, CreasesBehindAnObstacleAreNotVisible) {
  Scene scene = room_corner();
  const Rendering open = render(scene, kinect_like_camera(160));
  EXPECT_GT(total_length(visible_creases(scene, open, kRadius)), 2.0);
  const Vec3d eye = scene.world_from_camera.translation, ahead = scene.world_from_camera.rotation * Vec3d::UnitZ();
  add_surface(scene, Plane{eye + 0.5 * ahead, ahead});
  const Rendering blocked = render(scene, kinect_like_camera(160));
  EXPECT_TRUE(visible_creases(scene, blocked, kRadius).empty());
}

TEST(EdgeTruth, EveryPointOfAWireIsNearItsAxis) {
  const Scene scene = wire();
  const Rendering seen = render(scene, kinect_like_camera(320));
  const std::vector<Crease> visible = visible_creases(scene, seen, kRadius);
  const OrganizedCloud organized = unproject(seen.depth, seen.camera);
  for (std::size_t pixel = 0; pixel < seen.surface.size(); ++pixel) {
    if (seen.surface[pixel] < 1) continue;
    const Vec3d point = organized.cloud.points[organized.index.index[pixel]].cast<double>();
    EXPECT_NEAR(nearest_crease(visible, point).distance, 0.005, 1e-5);
  }
}

TEST(EdgeTruth, DiscontinuityRunsAlongTheBoard) {
  const Rendering seen = render(depth_step(), kinect_like_camera(160));
  const std::vector<bool> beside = beside_discontinuity(seen, 2, 0.1);
  int num_board = 0, num_beside_on_board = 0, num_beside = 0;
  for (std::size_t pixel = 0; pixel < beside.size(); ++pixel) {
    num_board += seen.surface[pixel] == 1;
    num_beside_on_board += seen.surface[pixel] == 1 && beside[pixel];
    num_beside += beside[pixel];
  }
  // A frame two pixels wide inside the board's image, w x h pixels: w h - (w - 4)(h - 4); and one outside of it.
  const int width = 63, height = 54;
  EXPECT_EQ(num_board, width * height);
  EXPECT_EQ(num_beside_on_board, width * height - (width - 4) * (height - 4));
  EXPECT_EQ(num_beside, (width + 4) * (height + 4) - (width - 4) * (height - 4));
}

TEST(EdgeTruth, CreaseIsNoDiscontinuity) {
  const Rendering seen = render(room_corner(), kinect_like_camera(160));
  const std::vector<bool> beside = beside_discontinuity(seen, 2, 0.3);
  EXPECT_EQ(std::count(beside.begin(), beside.end(), true), 0);
}

TEST(EdgeTruth, ContourBeforeNothingIsADiscontinuity) {
  const Rendering seen = render(sphere_scene(), kinect_like_camera(80));
  const std::vector<bool> beside = beside_discontinuity(seen, 1, 0.1);
  EXPECT_GT(std::count(beside.begin(), beside.end(), true), 40);
}

}  // namespace
}  // namespace augicp::testing
