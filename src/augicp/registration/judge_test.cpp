// SPDX-License-Identifier: MIT
#include "augicp/registration/judge.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "augicp/geometry/rotation.h"
#include "augicp/registration/registration.h"
#include "augicp/testing/matchers.h"
#include "augicp/testing/poses.h"
#include "augicp/testing/room_pair.h"
#include "augicp/testing/scenes.h"
#include "augicp/trust/beyond_planes.h"

namespace augicp {
namespace {

using Pair = testing::ScanPair;

Scan seen_from(const Rigid3& world_from_camera, unsigned seed, unsigned room = 1) {
  return testing::noisy_view(testing::room(room), world_from_camera, seed);
}

Scan as_cloud(const Scan& scan) {
  Cloud cloud = scan.cloud;
  cloud.viewpoint.reset();
  return scan_of(std::move(cloud));
}

Pair near_pair() {
  std::mt19937 generator(3);
  return testing::room_pair(testing::random_motion(generator, 0.1, 0.1));
}

// robustness 11: opposite walls of one room, and two rooms. Neither pair has a common surface.
std::vector<Pair> pairs_without_overlap() {
  const Rigid3 left = testing::look_at({0.4, -0.4, 1.4}, {-2.5, -0.2, 0.8});
  const Rigid3 right = testing::look_at({0.4, -0.4, 1.4}, {2.5, -0.2, 0.8});
  return {{seen_from(left, 1), seen_from(right, 2), {}}, {seen_from(left, 1), seen_from(left, 2, 7), {}}};
}

Evidence evidence_at(const Pair& pair, const Rigid3& pose) {
  const RegistrationOptions options;
  const PreparedPair prepared = prepare_pair(pair.source, pair.target, options);
  const bool projective = prepared.target.view.has_value();
  const auto matcher = matcher_for(prepared.target, projective, prepared.lengths);
  return Judge(prepared, *matcher, {}, align_options(prepared.lengths, projective, options)).evidence(pose);
}

TEST(Judge, TheRightPoseHasWitnessesBothWays) {
  const Pair pair = near_pair();
  const Evidence evidence = evidence_at(pair, pair.target_from_source);
  for (const Testimony& side : {evidence.source_in_target, evidence.target_in_source}) {
    EXPECT_TRUE(side.knows_free_space);
    EXPECT_GT(side.seen(), 0.7);
    EXPECT_GT(side.agreeing(), 0.9);
    EXPECT_LT(side.conflicting(), 0.02);
  }
  EXPECT_LT(evidence.residuals.point.median, 0.02);
  EXPECT_LT(evidence.residuals.normal.median, 0.05);
}

TEST(Judge, AWrongPoseHasWitnessesAgainstIt) {
  const Pair pair = near_pair();
  const Rigid3 off{Eigen::Quaterniond(Eigen::AngleAxisd(0.3, Vec3d::UnitY())), {0.2, 0, 0}};
  EXPECT_GT(strain(evidence_at(pair, pair.target_from_source * off)), 2.0);
  const Pair clouds{as_cloud(pair.source), as_cloud(pair.target), pair.target_from_source};
  EXPECT_GT(strain(evidence_at(clouds, pair.target_from_source * off)), 2.0);
}

// robustness 16: swapping the clouds swaps the witnesses, and so leaves the verdict.
TEST(Judge, SwappingChangesNothing) {
  const Pair pair = near_pair();
  const Evidence one = evidence_at(pair, pair.target_from_source);
  const Evidence other = evidence_at({pair.target, pair.source, {}}, inverse(pair.target_from_source));
  EXPECT_EQ(one.source_in_target.count, other.target_in_source.count);
  EXPECT_EQ(one.target_in_source.count, other.source_in_target.count);
}

TEST(Judge, RegistrationOfANearPairIsTrusted) {
  const Pair pair = near_pair();
  const AlignResult images = register_scans(pair.source, pair.target).result;
  EXPECT_EQ(images.status, AlignStatus::Converged);
  ASSERT_TRUE(images.evidence);
  EXPECT_TRUE(images.doubts.empty());
  const AlignResult clouds = register_scans(as_cloud(pair.source), as_cloud(pair.target)).result;
  EXPECT_EQ(clouds.status, AlignStatus::Converged);
}

// Clouds in the frame of a room, far from where they were seen, do not tell what was free.
TEST(Judge, CloudsKnowTheirFreeSpaceFromTheirSensorOnly) {
  const Pair pair = near_pair();
  const Rigid3 away{rotation_exp({0.2, 0.1, 0.3}), {0.5, -0.3, -1.5}};
  const auto moved = [&](const Scan& scan) { return scan_of(transform(as_cloud(scan).cloud, away)); };
  const Pair elsewhere{moved(pair.source), moved(pair.target), away * pair.target_from_source * inverse(away)};
  const Evidence evidence = evidence_at(elsewhere, elsewhere.target_from_source);
  EXPECT_FALSE(evidence.source_in_target.knows_free_space);
  EXPECT_FALSE(evidence.target_in_source.knows_free_space);
  EXPECT_EQ(evidence.source_in_target.count.conflict, 0);
}

// The same walls, but what stands before them is elsewhere.
Scan refurnished(const Scan& scan, const Lengths& lengths) {
  Cloud cloud = prepare(scan, lengths, {}).cloud;
  const std::vector<bool> is_on_plane = on_large_planes(cloud, 0.5 * lengths.radius);
  for (std::size_t i = 0; i < cloud.size(); ++i)
    if (!is_on_plane[i]) cloud.points[i] += Vec3f(0.4f, 0.3f, 0.2f);
  cloud.directions.clear();
  cloud.structures.clear();
  return scan_of(std::move(cloud));
}

TEST(Judge, WallsAloneThatAgreeAreNoticedWhereFreeSpaceIsUnknown) {
  const Pair pair = near_pair();
  const Rigid3 away{rotation_exp({0.2, 0.1, 0.3}), {0.5, -0.3, -1.5}};
  const auto moved = [&](const Scan& scan) { return scan_of(transform(as_cloud(scan).cloud, away)); };
  Pair elsewhere{moved(pair.source), moved(pair.target), away * pair.target_from_source * inverse(away)};
  const Evidence right = evidence_at(elsewhere, elsewhere.target_from_source);
  EXPECT_GT(std::max(right.source_in_target.off_planes, right.target_in_source.off_planes), 0.87);
  elsewhere.source = refurnished(elsewhere.source, derive_lengths(elsewhere.source, elsewhere.target));
  const Evidence wrong = evidence_at(elsewhere, elsewhere.target_from_source);
  EXPECT_LT(std::max(wrong.source_in_target.off_planes, wrong.target_in_source.off_planes), 0.75);
}

// A camera that has turned away from the furniture says nothing of it.
TEST(Judge, WhatIsOutOfACamerasViewIsNotComparedWithPlanes) {
  for (const unsigned room : {2u, 4u}) {
    const Rigid3 world_from_source = testing::look_at({0.2, -1.0, 1.5}, {0.0, 2.2, 0.6});
    const Rigid3 world_from_target = testing::look_at({0.4, -1.0, 1.5}, {1.1, 2.2, 0.6});
    const Pair pair{seen_from(world_from_source, 1, room), seen_from(world_from_target, 2, room), {}};
    const Evidence evidence = evidence_at(pair, inverse(world_from_target) * world_from_source);
    EXPECT_LT(evidence.source_in_target.seen(), 0.7) << room;
    EXPECT_GT(evidence.source_in_target.off_planes, 0.87) << room;
    EXPECT_GT(evidence.target_in_source.off_planes, 0.87) << room;
  }
}

// What the clouds' own sensors saw through speaks against a wrong pose as a depth image does, and not against the right
// one.
TEST(Judge, FreeSpaceOfCloudsSpeaksAgainstWrongPosesAlone) {
  const Pair pair = near_pair();
  const Pair clouds{as_cloud(pair.source), as_cloud(pair.target), pair.target_from_source};
  const Evidence right = evidence_at(clouds, pair.target_from_source);
  EXPECT_LT(right.source_in_target.conflicting(), 0.02);
  EXPECT_LT(right.target_in_source.conflicting(), 0.02);
  const Rigid3 off{rotation_exp({0.0, 0.3, 0.0}), {0.2, 0.0, 0.0}};
  const Evidence wrong = evidence_at(clouds, pair.target_from_source * off);
  EXPECT_GT(std::max(wrong.source_in_target.conflicting(), wrong.target_in_source.conflicting()), 0.1);
}

TEST(Judge, WithoutCommonSurfaceNothingIsTrusted) {
  for (const Pair& pair : pairs_without_overlap())
    EXPECT_NE(register_scans(pair.source, pair.target).result.status, AlignStatus::Converged);
}

// A corner without anything in it is found again from afar, but any other would be too; only a near guess tells which
// it is.
TEST(Judge, BareCornersAreTrustedNearTheGuessOnly) {
  const testing::Scene scene = testing::room_corner();
  const Rigid3 from = testing::look_at({0.8, 2.3, 1.7}, {0.4, 0.0, 0.3}), to = scene.world_from_camera;
  const Rigid3 motion = inverse(to) * from;
  const Scan source = testing::noisy_view(scene, from, 1), target = testing::noisy_view(scene, to, 2);
  const AlignResult far = register_scans(source, target).result;
  EXPECT_THAT(far.target_from_source, testing::NearPose(motion, 0.02, 0.05));
  EXPECT_LT(far.evidence->beyond_planes, 0.0025);
  EXPECT_GT(far.evidence->moved, 0.5);
  EXPECT_EQ(far.doubts, std::vector<Doubt>{Doubt::BarePlanes});
  const AlignResult near =
      register_scans(source, target, motion * Rigid3{rotation_exp({0.0, 0.05, 0.0}), {0.02, 0.0, 0.0}}).result;
  EXPECT_THAT(near.target_from_source, testing::NearPose(motion, 0.02, 0.05));
  EXPECT_EQ(near.status, AlignStatus::Converged);
}

// robustness 11: 100 m apart. That is no pose at all; but a search without a guess may find it.
TEST(Judge, APoseHasLeftTheGuessOnlyByMovingAlongWhatIsFree) {
  AlignResult result;
  result.status = AlignStatus::Degenerate;
  result.observability.directions = Mat6d::Identity();
  result.observability.gyration = 2.0;
  result.free_motions.resize(1);
  const auto has_left = [&](const Vec3d& translation) {
    result.target_from_source.translation = translation;
    return has_left_along_free(result, Rigid3{});
  };
  EXPECT_FALSE(has_left({0.0, 0.0, 0.0}));
  EXPECT_FALSE(has_left({0.01, 3.0, -4.0}));
  EXPECT_TRUE(has_left({-0.03, 0.0, 0.0}));
  result.free_motions.clear();
  EXPECT_FALSE(has_left({5.0, 0.0, 0.0}));
}

// The right pose, as if a motion were free there along which the guess is 10 cm away.
TEST(Judge, APoseThatHasLeftTheGuessAlongWhatIsFreeIsDoubtful) {
  const Pair pair = near_pair();
  const RegistrationOptions options;
  const PreparedPair prepared = prepare_pair(pair.source, pair.target, options);
  const auto matcher = matcher_for(prepared.target, true, prepared.lengths);
  AlignResult result;
  result.target_from_source = pair.target_from_source;
  result.status = AlignStatus::Degenerate;
  result.observability.directions = Mat6d::Identity();
  result.observability.gyration = 1.0;
  result.free_motions.resize(1);
  const auto judged = [&](const Vec3d& from_guess) {
    const Rigid3 guess{pair.target_from_source.rotation, pair.target_from_source.translation + from_guess};
    return Judge(prepared, *matcher, guess, align_options(prepared.lengths, true, options)).judged(result);
  };
  EXPECT_EQ(judged({0.0, 0.1, 0.0}).status, AlignStatus::Degenerate);
  EXPECT_THAT(judged({0.0, 0.1, 0.0}).doubts, ::testing::IsEmpty());
  EXPECT_EQ(judged({0.1, 0.0, 0.0}).status, AlignStatus::Doubtful);
  EXPECT_THAT(judged({0.1, 0.0, 0.0}).doubts, ::testing::ElementsAre(Doubt::LeftGuess));
}

// Three faces about the frame's zero, and a boss of this height on one of them, as a cloud that was sampled from
// outside.
Cloud faces_with_boss(float height_m) {
  std::mt19937 generator(5);
  std::uniform_real_distribution<float> side(-1.0f, 1.0f);
  Cloud cloud;
  for (std::size_t k = 0; k < 24000; ++k) {
    Vec3f point(side(generator), side(generator), side(generator));
    point[static_cast<int>(k % 3)] = 1.0f;
    const float from_boss = (point - Vec3f(1.0f, 0.4f, 0.4f)).cwiseAbs().maxCoeff();
    if (point.x() == 1.0f) point.x() += std::clamp(0.5f - from_boss, 0.0f, height_m);
    cloud.points.push_back(point);
  }
  return cloud;
}

// From the zero, which fits as the place of a sensor, the other's face hides the boss. It contradicts all the same,
// unless the clouds give that place.
TEST(Judge, WhatIsHiddenFromAPlaceThatIsOnlyAssumedMayContradict) {
  const auto evidence = [](bool has_viewpoint) {
    Pair pair{scan_of(faces_with_boss(0.3f)), scan_of(faces_with_boss(0.0f)), {}};
    if (has_viewpoint) pair.source.cloud.viewpoint = pair.target.cloud.viewpoint = Vec3f::Zero();
    return evidence_at(pair, {});
  };
  const Testimony assumed = evidence(false).source_in_target, known = evidence(true).source_in_target;
  EXPECT_TRUE(assumed.knows_free_space);
  EXPECT_TRUE(known.knows_free_space);
  EXPECT_EQ(assumed.count, known.count);
  EXPECT_GT(assumed.contradicting, VerdictLimits{}.max_contradicting);
  EXPECT_EQ(known.contradicting, 0.0);
}

TEST(Judge, FarApartIsNoOverlap) {
  const Pair pair = near_pair();
  const Rigid3 far{Eigen::Quaterniond::Identity(), {100.0, 0.0, 0.0}};
  RegistrationOptions no_search;
  no_search.search = false;
  EXPECT_EQ(register_scans(pair.source, pair.target, far, no_search).result.status, AlignStatus::NoOverlap);
  const Scan source = as_cloud(pair.source), target = as_cloud(pair.target);
  EXPECT_EQ(register_scans(source, target, far, no_search).result.status, AlignStatus::NoOverlap);
  const AlignResult searched = register_scans(source, target, far).result;
  EXPECT_TRUE(searched.status != AlignStatus::Converged ||
              ::testing::Value(searched.target_from_source, testing::NearPose(pair.target_from_source, 0.02, 0.05)));
}

TEST(Judge, ThreadsGiveTheSameEvidence) {
  const Pair pair = near_pair();
  RegistrationOptions options;
  options.num_threads = 1;
  const Evidence one = *register_scans(pair.source, pair.target, {}, options).result.evidence;
  options.num_threads = 4;
  const Evidence four = *register_scans(pair.source, pair.target, {}, options).result.evidence;
  EXPECT_EQ(one.source_in_target.count, four.source_in_target.count);
  EXPECT_EQ(one.target_in_source.count, four.target_in_source.count);
  EXPECT_EQ(one.residuals.point.median, four.residuals.point.median);
}

}  // namespace
}  // namespace augicp
