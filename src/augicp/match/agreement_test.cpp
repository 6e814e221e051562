// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "augicp/core/parallel.h"
#include "augicp/match/matcher.h"

namespace augicp {
namespace {

constexpr Pinhole kCamera{50.0, 50.0, 31.5, 23.5, 64, 48};
constexpr double kDepth = 2.0;
constexpr AgreementTolerance kTolerance{.distance = 0.01};

// A wall square to the camera, normals towards it.
OrganizedCloud wall(double depth = kDepth) {
  OrganizedCloud seen = unproject({64, 48, std::vector<float>(64 * 48, static_cast<float>(depth))}, kCamera);
  seen.cloud.directions.assign(seen.cloud.size(), Vec3f(0, 0, -1));
  seen.cloud.structures.assign(seen.cloud.size(), Structure::Planar);
  return seen;
}

Agreement as_seen_by_camera(const Cloud& source, const Rigid3& pose = {},
                            const AgreementTolerance& tolerance = kTolerance) {
  const OrganizedCloud target = wall();
  return ProjectiveMatcher(target.cloud, target.index, kCamera).agreement(source, pose, tolerance, 1);
}

Rigid3 away(double distance) { return {Eigen::Quaterniond::Identity(), {0, 0, distance}}; }

TEST(Agreement, TheSameWallAgreesWholly) {
  const Cloud source = wall().cloud;
  const Agreement agreement = as_seen_by_camera(source);
  EXPECT_EQ(agreement.agree, static_cast<std::int64_t>(source.size()));
  EXPECT_EQ(agreement.total(), agreement.agree);
}

TEST(Agreement, WhatStandsInFrontConflictsAndWhatStandsBehindIsHidden) {
  const Cloud source = wall().cloud;
  const auto all = static_cast<std::int64_t>(source.size());
  // The moved wall is seen under a smaller angle when it is farther away, so that all of it stays in view.
  EXPECT_EQ(as_seen_by_camera(source, away(0.2)).hidden, all);
  const Agreement nearer = as_seen_by_camera(source, away(-0.2));
  EXPECT_GT(nearer.conflict, all / 2);
  EXPECT_EQ(nearer.conflict + nearer.unseen, all);
  EXPECT_EQ(as_seen_by_camera(source, away(0.02)).differ, all);
}

TEST(Agreement, ToleranceGrowsWithDepthWhereAsked) {
  const Cloud source = wall().cloud;
  const AgreementTolerance wide{.distance = 0.01, .per_depth = 0.01};
  EXPECT_EQ(as_seen_by_camera(source, away(0.02), wide).agree, static_cast<std::int64_t>(source.size()));
}

TEST(Agreement, WhatIsTurnedDiffers) {
  Cloud source = wall().cloud;
  for (Vec3f& normal : source.directions) normal = Vec3f(1, 0, 0);
  EXPECT_EQ(as_seen_by_camera(source).differ, static_cast<std::int64_t>(source.size()));
}

TEST(Agreement, BehindTheCameraAndOutsideItsViewIsUnseen) {
  const Cloud source = wall().cloud;
  const auto all = static_cast<std::int64_t>(source.size());
  EXPECT_EQ(as_seen_by_camera(source, away(-5.0)).unseen, all);
  EXPECT_EQ(as_seen_by_camera(source, {Eigen::Quaterniond::Identity(), {1e30, 0, 0}}).unseen, all);
  Cloud at_zero = source;
  at_zero.points.assign(source.size(), Vec3f::Zero());
  EXPECT_EQ(as_seen_by_camera(at_zero).unseen, all);
}

TEST(Agreement, NearestKnowsNoFreeSpace) {
  const Cloud target = wall().cloud, source = target;
  const auto all = static_cast<std::int64_t>(source.size());
  const NearestMatcher matcher(target);
  EXPECT_EQ(matcher.agreement(source, {}, kTolerance, 1).agree, all);
  EXPECT_EQ(matcher.agreement(source, away(0.02), kTolerance, 1).differ, all);
  EXPECT_EQ(matcher.agreement(source, away(-0.2), kTolerance, 1).unseen, all);
}

TEST(Agreement, ThreadsCountAlike) {
  const OrganizedCloud target = wall();
  Cloud source = wall(1.99).cloud;
  while (source.size() < 2 * kLightBlockSize) {
    const Cloud once = source;
    source.points.insert(source.points.end(), once.points.begin(), once.points.end());
    source.directions.insert(source.directions.end(), once.directions.begin(), once.directions.end());
    source.structures.insert(source.structures.end(), once.structures.begin(), once.structures.end());
  }
  const Rigid3 pose{Eigen::Quaterniond(Eigen::AngleAxisd(0.1, Vec3d::UnitY())), {0.05, 0, 0}};
  const ProjectiveMatcher projective(target.cloud, target.index, kCamera);
  const NearestMatcher nearest(target.cloud);
  for (const ScanMatcher* matcher : std::initializer_list<const ScanMatcher*>{&projective, &nearest})
    EXPECT_EQ(matcher->agreement(source, pose, kTolerance, 4), matcher->agreement(source, pose, kTolerance, 1));
}

TEST(Agreement, ToleranceIsChecked) {
  EXPECT_THROW(as_seen_by_camera(wall().cloud, {}, {}), std::invalid_argument);
  EXPECT_THROW(as_seen_by_camera(wall().cloud, {}, {.distance = -1.0}), std::invalid_argument);
  EXPECT_THROW(as_seen_by_camera(wall().cloud, {}, {.distance = 1.0, .min_cosine = 2.0}), std::invalid_argument);
}

// 100 points agree under both poses, 30 are hidden under one.
TEST(Agreement, OnMoreThanChanceIsFourDeviations) {
  using enum PointAgreement;
  const auto points = [](std::size_t num_agreeing, std::size_t num_differing) {
    std::vector<PointAgreement> all(100 + num_agreeing, Agree);
    all.insert(all.end(), num_differing, Differ);
    all.insert(all.end(), 30, Hidden);
    return all;
  };
  std::vector<PointAgreement> others(points(0, 40));
  std::fill(others.end() - 30, others.end(), Agree);
  EXPECT_TRUE(agree_on_more(points(40, 0), others));
  EXPECT_TRUE(agree_on_more(points(17, 23), others)) << "17 of 17 are 4.1 deviations";
  EXPECT_FALSE(agree_on_more(points(15, 25), others)) << "15 of 15 are 3.9";
  EXPECT_FALSE(agree_on_more(others, points(40, 0)));
  EXPECT_FALSE(agree_on_more(others, others));
}

}  // namespace
}  // namespace augicp
