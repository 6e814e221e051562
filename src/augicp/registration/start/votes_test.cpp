// SPDX-License-Identifier: MIT
#include "augicp/registration/start/votes.h"

#include <gtest/gtest.h>

#include "augicp/core/angles.h"
#include "augicp/geometry/rotation.h"

namespace augicp {
namespace {

constexpr double kRadius = 0.1;

Cloud some_points() {
  Cloud cloud;
  for (int k = 0; k < 100; ++k)
    cloud.points.emplace_back(0.01F * static_cast<float>(k), 0.2F * static_cast<float>(k % 7), 0.0F);
  return cloud;
}

Rigid3 shifted(double along_x) { return {Eigen::Quaterniond::Identity(), {along_x, 0.0, 0.0}}; }
Rigid3 turned(double angle_deg) { return {rotation_exp(Vec3d(0.0, 0.0, angle_deg * kRadPerDeg)), Vec3d::Zero()}; }

double outvoted_at_zero(const std::vector<SeedPose>& seeds) { return outvoted(some_points(), {}, seeds, kRadius); }

TEST(Votes, CompareTheLargestSupportFarOffWithTheLargestNearby) {
  EXPECT_DOUBLE_EQ(outvoted_at_zero({{shifted(1.0), 90.0}, {shifted(0.1), 60.0}, {shifted(0.2), 20.0}}), 1.5);
  EXPECT_DOUBLE_EQ(outvoted_at_zero({{shifted(0.1), 60.0}, {shifted(1.0), 30.0}, {shifted(2.0), 15.0}}), 0.5);
}

TEST(Votes, ATurnIsAnotherPoseIfThePointsMove) {
  EXPECT_DOUBLE_EQ(outvoted_at_zero({{turned(90.0), 80.0}, {turned(1.0), 40.0}}), 2.0);
}

TEST(Votes, ASeedIsOfThisPoseUpToThreeAndAHalfRadii) {
  EXPECT_DOUBLE_EQ(outvoted_at_zero({{shifted(3.4 * kRadius), 60.0}}), 0.0);
  EXPECT_DOUBLE_EQ(outvoted_at_zero({{shifted(3.6 * kRadius), 60.0}, {{}, 60.0}}), 1.0);
}

TEST(Votes, WithoutASeedElsewhereNothingSpeaksAgainstThePose) {
  EXPECT_EQ(outvoted_at_zero({}), 0.0);
  EXPECT_EQ(outvoted_at_zero({{{}, 3.0}}), 0.0);
}

TEST(Votes, OfAPoseThatNoSeedProposedTheySayNothing) { EXPECT_EQ(outvoted_at_zero({{shifted(1.0), 25.0}}), 0.0); }

}  // namespace
}  // namespace augicp
