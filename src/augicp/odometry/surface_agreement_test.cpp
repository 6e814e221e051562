// SPDX-License-Identifier: MIT
#include "augicp/odometry/surface_agreement.h"

#include <gtest/gtest.h>

#include <cmath>

#include "augicp/match/matcher.h"

namespace augicp {
namespace {

// The plane z = 0 at the origin (5, 0, 0), and an edge along z at (50, 0, 0).
Cloud plane_and_edge() {
  Cloud target;
  target.origin = {5.0, 0.0, 0.0};
  target.points = {{0.0f, 0.0f, 0.0f}, {45.0f, 0.0f, 0.0f}};
  target.directions = {{0.0f, 0.0f, 1.0f}, {0.0f, 0.0f, 1.0f}};
  target.structures = {Structure::Planar, Structure::Edge};
  return target;
}

TEST(SurfaceAgreement, CountsPointsOnPlanesAndEdges) {
  const Cloud target = plane_and_edge();
  const NearestMatcher matcher(target);
  Cloud source;
  source.points = {{5.3f, 0.0f, 0.03f},   // 3 cm above the plane
                   {5.0f, 0.2f, 0.3f},    // too far above
                   {50.0f, 0.04f, 0.7f},  // 4 cm beside the edge
                   {50.0f, 0.3f, 0.0f},   // too far beside
                   {90.0f, 0.0f, 0.0f}};  // no partner
  Gates gates;
  gates.max_distance = 1.0;
  const Rigid3 pose = without_origins(Rigid3{}, source, target);
  const auto pairs = matcher.match(source, pose, gates, 1);
  const SurfaceAgreement found = surface_agreement({source, target, pairs, pose}, 0.05);
  EXPECT_DOUBLE_EQ(found.share, 0.4);
  EXPECT_NEAR(found.rmse, std::sqrt(0.5 * (0.03 * 0.03 + 0.04 * 0.04)), 1e-6);
}

TEST(SurfaceAgreement, IsNothingWherePointsHaveNoPartner) {
  const Cloud target = plane_and_edge();
  const NearestMatcher matcher(target);
  Cloud source;
  source.points = {{90.0f, 0.0f, 0.0f}};
  Gates gates;
  gates.max_distance = 1.0;
  const Rigid3 pose = without_origins(Rigid3{}, source, target);
  const auto pairs = matcher.match(source, pose, gates, 1);
  const SurfaceAgreement found = surface_agreement({source, target, pairs, pose}, 0.05);
  EXPECT_EQ(found.share, 0.0);
  EXPECT_EQ(found.rmse, 0.0);
}

}  // namespace
}  // namespace augicp
