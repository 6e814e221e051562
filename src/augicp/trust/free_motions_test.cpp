// SPDX-License-Identifier: MIT
#include "augicp/trust/free_motions.h"

#include <gtest/gtest.h>

namespace augicp {
namespace {

const Vec3d kCentroid(40.0, -7.0, 3.0);  // metres
constexpr double kGyration = 2.5;

// About the centroid: a rotation by one radian over a gyration radius counts as a metre.
Vec6d direction(const Vec3d& translation, const Vec3d& turn) {
  Vec6d increment;
  increment << translation - turn.cross(kCentroid), turn;
  return increment;
}

Observability seen() {
  Observability seen;
  seen.centroid = kCentroid;
  seen.gyration = kGyration;
  for (int k = 0; k < 3; ++k) {
    seen.directions.col(k) = direction(Vec3d::Unit(2 - k), Vec3d::Zero());
    seen.directions.col(3 + k) = direction(Vec3d::Zero(), Vec3d::Unit(k) / kGyration);
  }
  return seen;
}

TEST(MovedAlong, CountsTheFreeDirectionsOnlyInGyrationRadii) {
  const Vec6d rise = direction(Vec3d(0.0, 0.0, 0.5), Vec3d::Zero());
  EXPECT_NEAR(moved_along(seen(), 1, rise), 0.5 / kGyration, 1e-12);
  EXPECT_NEAR(moved_along(seen(), 1, direction(Vec3d(3.0, 4.0, 0.0), Vec3d(0.1, 0.2, 0.3))), 0.0, 1e-12);
  EXPECT_NEAR(moved_along(seen(), 3, direction(Vec3d(3.0, 4.0, 0.0), Vec3d(0.1, 0.2, 0.3))), 5.0 / kGyration, 1e-12);
}

TEST(MovedAlong, ATurnAboutTheCentroidCountsByItsAngle) {
  EXPECT_NEAR(moved_along(seen(), 4, direction(Vec3d::Zero(), Vec3d(0.2, 0.0, 0.0))), 0.2, 1e-12);
  EXPECT_NEAR(moved_along(seen(), 6, direction(Vec3d::Zero(), Vec3d(0.0, 0.3, 0.4))), 0.5, 1e-12);
}

TEST(MovedAlong, NothingIsMovedAlongNoDirectionAndWithoutExtent) {
  EXPECT_EQ(moved_along(seen(), 0, Vec6d::Ones()), 0.0);
  EXPECT_EQ(moved_along(Observability{}, 2, Vec6d::Ones()), 0.0);
}

}  // namespace
}  // namespace augicp
