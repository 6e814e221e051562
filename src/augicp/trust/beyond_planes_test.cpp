// SPDX-License-Identifier: MIT
#include "augicp/trust/beyond_planes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>

#include "augicp/geometry/rotation.h"
#include "augicp/testing/poses.h"

namespace augicp {
namespace {

constexpr AgreementTolerance kPlaneTolerance{.distance = 0.02, .per_depth = 0.0};
constexpr int kPointsPerPlane = 500;

void add(Cloud& cloud, const Vec3d& point, const Vec3d& direction, Structure structure) {
  cloud.points.push_back(point.cast<float>());
  cloud.directions.push_back(direction.cast<float>());
  cloud.structures.push_back(structure);
}

// A square of 2 m with noise of 3 mm, and normals that are two degrees off.
void add_plane(Cloud& cloud, const Vec3d& normal, const Vec3d& centre, std::mt19937& generator) {
  const Vec3d across = normal.unitOrthogonal(), along = normal.cross(across);
  for (int k = 0; k < kPointsPerPlane; ++k) {
    const Vec3d at = testing::random_direction(generator), off = testing::random_direction(generator);
    add(cloud, centre + at.x() * across + at.y() * along + 0.003 * off.z() * normal, (normal + 0.05 * off).normalized(),
        Structure::Planar);
  }
}

const Mat3d kAxes = rotation_exp({0.3, -0.2, 0.5}).toRotationMatrix();

Cloud corner(std::mt19937& generator) {
  Cloud cloud;
  for (int axis = 0; axis < 3; ++axis)
    add_plane(cloud, kAxes.col(axis), kAxes * (Vec3d::Ones() - Vec3d::Unit(axis)), generator);
  return cloud;
}

std::vector<std::uint32_t> all_of(const Cloud& cloud) {
  std::vector<std::uint32_t> all(cloud.size());
  for (std::uint32_t i = 0; i < all.size(); ++i) all[i] = i;
  return all;
}

TEST(BeyondPlanes, ACornerHasNothing) {
  std::mt19937 generator(1);
  const Cloud cloud = corner(generator);
  EXPECT_LT(share_beyond_planes(cloud, all_of(cloud), kPlaneTolerance), 0.005);
}

TEST(BeyondPlanes, AFourthPlaneIsBeyond) {
  std::mt19937 generator(2);
  Cloud cloud = corner(generator);
  add_plane(cloud, kAxes * Vec3d::Ones().normalized(), kAxes * Vec3d(5, 5, 5), generator);
  EXPECT_NEAR(share_beyond_planes(cloud, all_of(cloud), kPlaneTolerance), 0.25, 0.01);
}

TEST(BeyondPlanes, AreFoundAmongAnyOtherPoints) {
  std::mt19937 generator(3);
  Cloud cloud = corner(generator);
  constexpr int kOthers = 100;
  for (int k = 0; k < kOthers; ++k)
    add(cloud, Vec3d(9, 9, 9) + testing::random_direction(generator), Vec3d::UnitX(), Structure::None);
  const double share = static_cast<double>(kOthers) / static_cast<double>(cloud.size());
  EXPECT_NEAR(share_beyond_planes(cloud, all_of(cloud), kPlaneTolerance), share, 0.005);
}

TEST(BeyondPlanes, WithoutPlanesEverythingIs) {
  EXPECT_EQ(share_beyond_planes({}, {}, kPlaneTolerance), 1.0);
  std::mt19937 generator(4);
  Cloud cloud;
  for (int k = 0; k < 100; ++k) add(cloud, testing::random_direction(generator), Vec3d::UnitX(), Structure::None);
  EXPECT_EQ(share_beyond_planes(cloud, all_of(cloud), kPlaneTolerance), 1.0);
}

// Seen from the origin, what is a centimetre off agrees at 2 m and differs at 0.5 m.
TEST(BeyondPlanes, ToleranceGrowsWithDepth) {
  Cloud cloud;
  cloud.viewpoint = Vec3f::Zero();
  for (const double depth : {2.0, 0.5}) add(cloud, {0, 0, depth}, Vec3d::UnitZ(), Structure::Planar);
  const std::vector<Correspondence> pairs{{0, 0}, {1, 1}};
  const Rigid3 off{Eigen::Quaterniond::Identity(), {0.0, 0.0, 0.01}};
  EXPECT_EQ(agreeing_points({cloud, cloud, pairs, off}, {.distance = 0.0, .per_depth = 0.015}),
            (std::vector<std::uint32_t>{0}));
}

// Along a plane the points of a pair may be apart. Off it, or with another normal, they do not agree. Without a plane,
// distance counts in all directions.
TEST(AgreeingPoints, AreOnTheSurfaceAndTurnedAlike) {
  Cloud source, target;
  const Vec3d z = Vec3d::UnitZ(), askew = (Vec3d::UnitX() + z).normalized();
  const auto add_pair = [&](const Vec3d& from, const Vec3d& direction, Structure structure) {
    add(source, from, direction, structure);
    add(target, Vec3d::Zero(), z, structure);
  };
  add_pair({0.3, 0.0, 0.01}, z, Structure::Planar);
  add_pair({0.0, 0.0, 0.03}, z, Structure::Planar);
  add_pair({0.0, 0.0, 0.01}, askew, Structure::Planar);
  add_pair({0.01, 0.0, 0.0}, z, Structure::None);
  add_pair({0.3, 0.0, 0.0}, z, Structure::None);
  std::vector<Correspondence> pairs;
  for (std::uint32_t i = 0; i < source.size(); ++i) pairs.push_back({i, i});
  EXPECT_EQ(agreeing_points({source, target, pairs, {}}, kPlaneTolerance), (std::vector<std::uint32_t>{0, 3}));
}

// Three planes, and clutter of a fifth of the points.
TEST(LargePlanes, AreWhereTheWallsAre) {
  std::mt19937 generator(7);
  Cloud room = corner(generator);
  const std::size_t num_on_walls = room.size();
  for (int k = 0; k < 300; ++k)
    add(room, kAxes * Vec3d(0.6, 0.6, 0.6) + 0.4 * testing::random_direction(generator),
        testing::random_direction(generator), Structure::Planar);
  const std::vector<bool> is_on = on_large_planes(room, kPlaneTolerance.distance);
  const auto first_off = is_on.begin() + static_cast<std::ptrdiff_t>(num_on_walls);
  EXPECT_GT(std::count(is_on.begin(), first_off, true), 0.99 * static_cast<double>(num_on_walls));
  EXPECT_LT(std::count(first_off, is_on.end(), true), 60);  // the planes cross the clutter
}

TEST(LargePlanes, ABallHasNone) {
  std::mt19937 generator(8);
  Cloud ball;
  for (int k = 0; k < 3000; ++k) {
    const Vec3d direction = testing::random_direction(generator);
    add(ball, direction, direction, Structure::Planar);
  }
  const std::vector<bool> is_on = on_large_planes(ball, 0.005);
  EXPECT_EQ(std::count(is_on.begin(), is_on.end(), true), 0);
  EXPECT_TRUE(on_large_planes(Cloud{}, 0.005).empty());
}

// 80 of 100 on planes agree, and 10 of 50 off them: 0.2 / 0.8. Hidden points and those in free space say nothing of it.
TEST(AgreementOffPlanes, IsTheRatioOfTheShares) {
  std::vector<PointAgreement> said;
  std::vector<bool> is_on;
  const auto add_points = [&](int count, bool on, PointAgreement one) {
    for (int k = 0; k < count; ++k) {
      said.push_back(one);
      is_on.push_back(on);
    }
  };
  add_points(80, true, PointAgreement::Agree);
  add_points(20, true, PointAgreement::Unseen);
  add_points(10, false, PointAgreement::Agree);
  add_points(40, false, PointAgreement::Differ);
  EXPECT_DOUBLE_EQ(agreement_off_planes(said, is_on), 0.25);
  add_points(30, false, PointAgreement::Hidden);
  add_points(30, false, PointAgreement::Conflict);
  EXPECT_DOUBLE_EQ(agreement_off_planes(said, is_on), 0.25);
}

TEST(AgreementOffPlanes, FewPointsOfEitherKindSayNothing) {
  std::vector<PointAgreement> said(100, PointAgreement::Agree);
  std::vector<bool> is_on(100, true);
  for (std::size_t k = 0; k < 4; ++k) said[k] = PointAgreement::Unseen, is_on[k] = false;
  EXPECT_EQ(agreement_off_planes(said, is_on), 1.0);
  is_on.flip();
  EXPECT_EQ(agreement_off_planes(said, is_on), 1.0);
  EXPECT_EQ(agreement_off_planes({}, {}), 1.0);
}

}  // namespace
}  // namespace augicp
