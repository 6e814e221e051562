// SPDX-License-Identifier: MIT
#include "augicp/testing/surfaces.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "augicp/testing/matchers.h"
#include "augicp/testing/poses.h"

namespace augicp::testing {
namespace {

const Ray kForward{Vec3d::Zero(), Vec3d(0.0, 0.0, 2.0)};

struct Case {
  Surface surface;
  double distance;  // in lengths of the ray's direction, 2 m
};

TEST(Surfaces, RayStraightAheadHitsTheNearSide) {
  const Case cases[] = {{Plane{{5.0, 5.0, 3.0}, Vec3d::UnitZ()}, 1.5},
                        {Rectangle{{-1.0, -1.0, 3.0}, {2.0, 0.0, 0.0}, {0.0, 2.0, 0.0}}, 1.5},
                        {Sphere{{0.0, 0.0, 3.0}, 1.0}, 1.0},
                        {Cylinder{{-1.0, 0.0, 3.0}, {1.0, 0.0, 3.0}, 1.0}, 1.0}};
  for (const Case& one : cases) {
    const auto found = intersect(one.surface, kForward);
    ASSERT_TRUE(found);
    EXPECT_NEAR(found->distance, one.distance, 1e-15);
    EXPECT_THAT(found->normal, NearVector(Vec3d(0.0, 0.0, -1.0), 1e-15));
  }
}

TEST(Surfaces, WhatIsBehindOrBesideIsNotHit) {
  const Surface missed[] = {Plane{{0.0, 0.0, -3.0}, Vec3d::UnitZ()},
                            Plane{{0.0, 1.0, 0.0}, Vec3d::UnitY()},
                            Rectangle{{0.1, -1.0, 3.0}, {2.0, 0.0, 0.0}, {0.0, 2.0, 0.0}},
                            Sphere{{0.0, 0.0, -3.0}, 1.0},
                            Sphere{{0.0, 1.1, 3.0}, 1.0},
                            Cylinder{{-1.0, 1.1, 3.0}, {1.0, 1.1, 3.0}, 1.0},
                            Cylinder{{0.1, 0.0, 3.0}, {1.0, 0.0, 3.0}, 1.0}};
  for (const Surface& surface : missed) EXPECT_FALSE(intersect(surface, kForward)) << surface.index();
}

TEST(Surfaces, FromInsideTheFarSideIsHitAndTheNormalTurnsInwards) {
  const Surface around[] = {Sphere{Vec3d::Zero(), 3.0}, Cylinder{{-1.0, 0.0, 0.0}, {1.0, 0.0, 0.0}, 3.0}};
  for (const Surface& surface : around) {
    const auto found = intersect(surface, kForward);
    ASSERT_TRUE(found);
    EXPECT_NEAR(found->distance, 1.5, 1e-15);
    EXPECT_THAT(found->normal, NearVector(Vec3d(0.0, 0.0, -1.0), 1e-15));
  }
}

TEST(Surfaces, HitsOfAnyRayLieOnTheSurface) {
  std::mt19937 generator(5);
  const Vec3d axis = Vec3d(1.0, 2.0, -0.5).normalized();
  int num_hits = 0;
  for (int i = 0; i < 2000; ++i) {
    const Ray ray{4.0 * random_direction(generator), random_direction(generator)};
    if (const auto found = intersect(Sphere{Vec3d::Zero(), 2.0}, ray)) {
      EXPECT_THAT(ray.origin + found->distance * ray.direction, NearVector(Vec3d(2.0 * found->normal), 1e-12));
      ++num_hits;
    }
    if (const auto found = intersect(Cylinder{-2.0 * axis, 2.0 * axis, 1.0}, ray)) {
      const Vec3d point = ray.origin + found->distance * ray.direction;
      EXPECT_NEAR(point.cross(axis).norm(), 1.0, 1e-12);
      EXPECT_LE(std::abs(point.dot(axis)), 2.0);
      EXPECT_LE(found->normal.dot(ray.direction), 0.0);
      ++num_hits;
    }
  }
  EXPECT_GT(num_hits, 100);
}

}  // namespace
}  // namespace augicp::testing
