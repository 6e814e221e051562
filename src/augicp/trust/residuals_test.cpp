// SPDX-License-Identifier: MIT
#include "augicp/trust/residuals.h"

#include <gtest/gtest.h>

namespace augicp {
namespace {

// Two planar points, one edge, one without structure.
Cloud four_points() {
  Cloud cloud;
  cloud.points = {{0, 0, 1}, {1, 0, 1}, {0, 1, 1}, {1, 1, 1}};
  cloud.directions = {{0, 0, -1}, {0, 0, -1}, {1, 0, 0}, {0, 0, 0}};
  cloud.structures = {Structure::Planar, Structure::Planar, Structure::Edge, Structure::None};
  return cloud;
}

const std::vector<Correspondence> kPairs{{0, 0}, {1, 1}, {2, 2}, {3, 3}};

TEST(Residuals, EachQuantityHasItsOwn) {
  const Cloud cloud = four_points();
  const Residuals none = residuals({cloud, cloud, kPairs, {}});
  EXPECT_EQ(none.point.count, 2);
  EXPECT_EQ(none.normal.count, 2);
  EXPECT_EQ(none.tangent.count, 1);
  EXPECT_EQ(none.point.median + none.normal.median + none.tangent.median, 0.0);

  const Residuals shifted = residuals({cloud, cloud, kPairs, {Eigen::Quaterniond::Identity(), {0.5, 0, 0.01}}});
  EXPECT_NEAR(shifted.point.median, 0.01, 1e-6);  // along the plane nothing shows
  EXPECT_EQ(shifted.normal.median, 0.0);

  const Residuals turned =
      residuals({cloud, cloud, kPairs, {Eigen::Quaterniond(Eigen::AngleAxisd(0.1, Vec3d::UnitY())), {}}});
  EXPECT_NEAR(turned.normal.median, 0.1, 1e-3);
  EXPECT_NEAR(turned.tangent.median, 0.1, 1e-3);
}

TEST(Residuals, SignsCountWhereTheyAreKnown) {
  Cloud source = four_points(), target = four_points();
  for (Vec3f& direction : source.directions) direction = -direction;
  EXPECT_EQ(residuals({source, target, kPairs, {}}).normal.median, 0.0);
  source.viewpoint = target.viewpoint = Vec3f::Zero();
  const Residuals signed_ones = residuals({source, target, kPairs, {}});
  EXPECT_NEAR(signed_ones.normal.median, 3.14159265, 1e-6);
  EXPECT_EQ(signed_ones.tangent.median, 0.0);
}

TEST(Residuals, NothingForBarePoints) {
  Cloud bare = four_points();
  bare.directions.clear();
  bare.structures.clear();
  EXPECT_EQ(residuals({bare, four_points(), kPairs, {}}).point.count, 0);
  EXPECT_EQ(residuals({four_points(), four_points(), {}, {}}).point.count, 0);
}

}  // namespace
}  // namespace augicp
