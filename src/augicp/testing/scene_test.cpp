// SPDX-License-Identifier: MIT
#include "augicp/testing/scene.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "augicp/testing/matchers.h"
#include "augicp/testing/poses.h"
#include "augicp/testing/scenes.h"

namespace augicp::testing {
namespace {

// How far a point is from a surface's infinite continuation.
double distance_to(const Surface& surface, const Vec3d& point) {
  if (const auto* patch = std::get_if<Rectangle>(&surface))
    return std::abs(patch->side_u.cross(patch->side_v).normalized().dot(point - patch->corner));
  const auto& cylinder = std::get<Cylinder>(surface);
  const Vec3d axis = (cylinder.end - cylinder.begin).normalized();
  return std::abs((point - cylinder.begin).cross(axis).norm() - cylinder.radius);
}

TEST(Scene, CreasesOfABoxAreItsTwelveEdges) {
  std::mt19937 generator(1);
  const Vec3d size(1.0, 2.0, 3.0);
  Scene scene;
  const Rigid3 world_from_box = random_motion(generator, 1.0, 2.0);
  add_box(scene, world_from_box, size);
  ASSERT_EQ(scene.surfaces.size(), 6u);
  ASSERT_EQ(scene.creases.size(), 12u);
  std::set<std::pair<int, int>> pairs_of_faces;
  std::multiset<int> lengths;
  for (const Crease& crease : scene.creases) {
    pairs_of_faces.emplace(std::minmax(crease.first_surface, crease.second_surface));
    lengths.insert(static_cast<int>(std::lround((crease.end - crease.begin).norm())));
    for (const Vec3d& end : {crease.begin, crease.end})
      EXPECT_THAT((inverse(world_from_box) * end).cwiseAbs(), NearVector(Vec3d(0.5 * size), 1e-12));
  }
  EXPECT_EQ(pairs_of_faces.size(), 12u);
  EXPECT_EQ(lengths, (std::multiset<int>{1, 1, 1, 1, 2, 2, 2, 2, 3, 3, 3, 3}));
}

TEST(Scene, CreasesOfTheReadyScenesLieOnBothTheirSurfaces) {
  for (const Scene& scene : {box_on_table(), room_corner(), room(1), room(2), corridor()}) {
    ASSERT_FALSE(scene.creases.empty());
    for (const Crease& crease : scene.creases) {
      for (int surface : {crease.first_surface, crease.second_surface}) {
        EXPECT_LE(distance_to(scene.surfaces.at(surface), crease.begin), 1e-12);
        EXPECT_LE(distance_to(scene.surfaces.at(surface), crease.end), 1e-12);
      }
      EXPECT_NE(crease.first_surface, crease.second_surface);
    }
  }
}

TEST(Scene, WireAxisIsItsCrease) {
  const Scene scene = wire();
  ASSERT_EQ(scene.creases.size(), 2u);
  for (const Crease& crease : scene.creases) {
    EXPECT_EQ(crease.first_surface, crease.second_surface);
    const auto& cylinder = std::get<Cylinder>(scene.surfaces.at(crease.first_surface));
    EXPECT_LE((cylinder.end - cylinder.begin).cross(crease.tangent()).norm(), 1e-12);
  }
}

TEST(Scene, ScenesWithoutCreasesHaveNone) {
  for (const Scene& scene : {depth_step(), single_plane(), two_parallel_planes(), sphere_scene(), cylinder_scene()})
    EXPECT_TRUE(scene.creases.empty());
}

TEST(Scene, LookAtPutsThePointOnTheAxisAndKeepsTheImageUpright) {
  const Vec3d eye(1.0, -2.0, 0.5), point(3.0, 1.0, 2.0);
  const Rigid3 camera_from_world = inverse(look_at(eye, point));
  EXPECT_THAT(camera_from_world * point, NearVector(Vec3d(0.0, 0.0, (point - eye).norm()), 1e-12));
  const Vec3d up = camera_from_world.rotation * Vec3d::UnitZ();
  EXPECT_NEAR(up.x(), 0.0, 1e-12);
  EXPECT_LT(up.y(), 0.0);
}

}  // namespace
}  // namespace augicp::testing
