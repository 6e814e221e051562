// SPDX-License-Identifier: MIT
#include "augicp/odometry/seen_through.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "augicp/geometry/rotation.h"

namespace augicp {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

constexpr double kWallVoxel = 0.5;

// Rays of a sensor at zero to the wall x = distance, half a degree apart.
Cloud wall_seen_at(float distance) {
  Cloud scan;
  for (int a = -20; a <= 20; ++a)
    for (int e = -20; e <= 20; ++e) {
      const Vec3f ray(1.0f, std::tan(0.009f * static_cast<float>(a)), std::tan(0.009f * static_cast<float>(e)));
      scan.points.push_back(distance * ray);
    }
  return scan;
}

Cloud one_plane(const Vec3f& point, const Vec3f& normal, Structure structure = Structure::Planar) {
  Cloud surfaces;
  surfaces.points = {point};
  surfaces.directions = {normal};
  surfaces.structures = {structure};
  return surfaces;
}

const Vec3f kAcross(1.0f, 0.0f, 0.0f);

TEST(SeenThrough, WhatRaysCrossIsGone) {
  EXPECT_THAT(seen_through(one_plane({8.0f, 0.3f, 0.2f}, kAcross), wall_seen_at(15.0f), Rigid3{}, kWallVoxel),
              ElementsAre(0u));
}

TEST(SeenThrough, WhatIsSeenOrHiddenStays) {
  const Cloud plane = one_plane({8.0f, 0.3f, 0.2f}, kAcross);
  EXPECT_THAT(seen_through(plane, wall_seen_at(8.0f), Rigid3{}, kWallVoxel), IsEmpty());
  EXPECT_THAT(seen_through(plane, wall_seen_at(8.3f), Rigid3{}, kWallVoxel), IsEmpty());  // within the margin
  EXPECT_THAT(seen_through(plane, wall_seen_at(4.0f), Rigid3{}, kWallVoxel), IsEmpty());
  EXPECT_THAT(seen_through(one_plane({-8.0f, 0.3f, 0.2f}, kAcross), wall_seen_at(15.0f), Rigid3{}, kWallVoxel),
              IsEmpty());
}

// One ray that ends on the surface is worth more than all that pass: a fence, or leaves.
TEST(SeenThrough, OneRayThatEndsThereKeepsIt) {
  Cloud scan = wall_seen_at(15.0f);
  scan.points.emplace_back(8.0f, 0.3f, 0.2f);
  EXPECT_THAT(seen_through(one_plane({8.0f, 0.3f, 0.2f}, kAcross), scan, Rigid3{}, kWallVoxel), IsEmpty());
}

// Rays to far ground pass over near ground at a grazing angle.
TEST(SeenThrough, GroundIsNotCrossedByRaysAboveIt) {
  Cloud scan;
  for (int e = 1; e <= 40; ++e)
    for (int a = -20; a <= 20; ++a) {
      const float distance = 1.5f / std::tan(0.009f * static_cast<float>(e) + 0.03f);
      scan.points.emplace_back(distance, distance * 0.009f * static_cast<float>(a), -1.5f);
    }
  Cloud ground;
  for (int k = 5; k < 30; ++k) {
    ground.points.emplace_back(static_cast<float>(k), 0.0f, -1.5f);
    ground.directions.emplace_back(0.0f, 0.0f, 1.0f);
    ground.structures.push_back(Structure::Planar);
  }
  EXPECT_THAT(seen_through(ground, scan, Rigid3{}, kWallVoxel), IsEmpty());
}

TEST(SeenThrough, FewOrGrazingRaysAndEdgesSayNothing) {
  Cloud two = wall_seen_at(15.0f);
  two.points.resize(2);
  const Vec3f on_their_way = two.points[1] / 2.0f;
  EXPECT_THAT(seen_through(one_plane(on_their_way, kAcross), two, Rigid3{}, kWallVoxel), IsEmpty());
  const Cloud wall = wall_seen_at(15.0f);
  EXPECT_THAT(seen_through(one_plane({8.0f, 0.0f, 0.0f}, {0.05f, 0.9987f, 0.0f}), wall, Rigid3{}, kWallVoxel),
              IsEmpty());
  EXPECT_THAT(seen_through(one_plane({8.0f, 0.3f, 0.2f}, kAcross, Structure::Edge), wall, Rigid3{}, kWallVoxel),
              IsEmpty());
  EXPECT_THAT(seen_through(Cloud{}, wall, Rigid3{}, kWallVoxel), IsEmpty());
  EXPECT_THAT(seen_through(one_plane({8.0f, 0.3f, 0.2f}, kAcross), Cloud{}, Rigid3{}, kWallVoxel), IsEmpty());
}

// The same in another frame, with an origin, behind the sensor where azimuths wrap around.
TEST(SeenThrough, DoesNotDependOnTheFrames) {
  const Rigid3 map_from_scan{rotation_exp({0.2, -0.1, 3.1}), {30.0, -20.0, 4.0}};
  Cloud moved = transform(one_plane({8.0f, 0.3f, 0.2f}, kAcross), map_from_scan);
  const Vec3d shift(28.0, -19.0, 3.0);
  moved.points[0] = (moved.origin + moved.points[0].cast<double>() - shift).cast<float>();
  moved.origin = shift;
  EXPECT_THAT(seen_through(moved, wall_seen_at(15.0f), map_from_scan, kWallVoxel), ElementsAre(0u));
  const Rigid3 half_turn{rotation_exp({0.0, 0.0, 3.14159265358979}), Vec3d::Zero()};
  EXPECT_THAT(seen_through(transform(one_plane({8.0f, 0.0f, 0.2f}, kAcross), half_turn),
                           transform(wall_seen_at(15.0f), half_turn), Rigid3{}, kWallVoxel),
              ElementsAre(0u));
}

}  // namespace
}  // namespace augicp
