// SPDX-License-Identifier: MIT
#include "augicp/registration/slid.h"

#include <gmock/gmock.h>

#include "augicp/registration/registration.h"
#include "augicp/registration/scan_match.h"
#include "augicp/testing/room_pair.h"

namespace augicp {
namespace {

// Two clouds of a room, and a result at a pose this far along x from the right one, with little information along x.
struct Slid {
  explicit Slid(double along_x_radii) {
    const testing::ScanPair room = testing::room_pair({});
    pair = prepare_pair(scan_of(room.source.cloud), scan_of(room.target.cloud), {});
    result = register_prepared(pair, {}, {});
    const Rigid3 right = without_origins(result.target_from_source, pair.source.cloud, pair.target.cloud);
    const Vec6d along_x = (Vec6d() << along_x_radii * pair.lengths.radius, Vec5d::Zero()).finished();
    result.target_from_source = retract(right, along_x);
    result.observability.directions = Mat6d::Identity();
    result.observability.information << 1e-6, 0.1, 0.2, 0.3, 0.4, 1.0;
  }
  using Vec5d = Eigen::Matrix<double, 5, 1>;

  AlignResult asked(const Guess& guess) const { return unless_slid(result, pair, guess, {}); }

  PreparedPair pair;
  AlignResult result;
};

TEST(Slid, AtTheRightPoseAStepLosesToEitherSide) {
  const Slid slid(0.0);
  ASSERT_EQ(slid.result.status, AlignStatus::Converged);
  EXPECT_EQ(slid.asked(Rigid3{}).status, AlignStatus::Converged);
}

TEST(Slid, BesideItAStepBackLosesNothing) {
  const Slid slid(1.0);
  const AlignResult without = slid.asked(std::nullopt);
  EXPECT_EQ(without.status, AlignStatus::Degenerate);
  ASSERT_EQ(without.free_motions.size(), 1u);
  EXPECT_EQ(without.free_motions[0].kind, FreeMotion::Kind::Translation);
  EXPECT_NEAR(std::abs(without.free_motions[0].axis.x()), 1.0, 1e-9);
  EXPECT_FALSE(without.covariance);
}

TEST(Slid, WhatHasLeftTheGuessIsDoubtful) {
  const Slid slid(1.0);
  const AlignResult left = slid.asked(Rigid3{});
  EXPECT_EQ(left.status, AlignStatus::Doubtful);
  EXPECT_THAT(left.doubts, ::testing::ElementsAre(Doubt::LeftGuess));
  EXPECT_EQ(slid.asked(slid.result.target_from_source).status, AlignStatus::Degenerate);
}

TEST(Slid, WhatIsHeldByInformationIsNotAsked) {
  Slid slid(1.0);
  slid.result.observability.information[0] = 0.01;
  EXPECT_EQ(slid.asked(Rigid3{}).status, AlignStatus::Converged);
}

}  // namespace
}  // namespace augicp
