// SPDX-License-Identifier: MIT
#include "augicp/registration/start/hypotheses.h"

#include <gmock/gmock.h>

#include "augicp/testing/matchers.h"
#include "augicp/testing/poses.h"

namespace augicp {
namespace {

using testing::NearPose;
using testing::NearVector;

TEST(Plausibility, IsOneWhereAllAgreesAndNothingWhereNothingIsSeen) {
  EXPECT_EQ(plausibility({.agree = 7}), 1.0);
  EXPECT_EQ(plausibility({.unseen = 7}), 0.0);
  EXPECT_EQ(plausibility({}), 0.0);
}

// Little overlap that agrees is better than much that does not.
TEST(Plausibility, AConflictCostsMoreThanManyAgree) {
  EXPECT_GT(plausibility({.agree = 15, .unseen = 85}),
            plausibility({.agree = 60, .differ = 10, .conflict = 7, .hidden = 10}));
  EXPECT_LT(plausibility({.agree = 50, .conflict = 10, .unseen = 40}), 0.0);
}

TEST(Turned, KeepsTheGuessFirstAndTheirPlace) {
  for (const Rigid3& guess : testing::awkward_poses()) {
    const Vec3d place = guess * Vec3d(0.3, -0.2, 1.5);
    const std::vector<Rigid3> guesses = turned(guess, place, {0.5, 1.0});
    ASSERT_EQ(guesses.size(), 1u + 2u * 14u);
    EXPECT_THAT(guesses.front(), NearPose(guess, 0.0, 0.0));
    for (std::size_t k = 1; k < guesses.size(); ++k) {
      EXPECT_NEAR(angle_between(guesses[k], guess), k <= 14 ? 0.5 : 1.0, 1e-6);
      EXPECT_THAT(guesses[k] * Vec3d(0.3, -0.2, 1.5), NearVector(place, 1e-6 * (1.0 + place.norm())));
    }
  }
}

TEST(BestOf, IsInOrderWithoutTwins) {
  const auto at = [](double x, double plausibility) {
    return Hypothesis{{Eigen::Quaterniond::Identity(), {x, 0, 0}}, plausibility};
  };
  const auto best = best_of({at(0.0, 0.1), at(1.0, 0.9), at(1.01, 0.8), at(2.0, 0.5)}, 2, 0.1, 0.1);
  ASSERT_EQ(best.size(), 2u);
  EXPECT_EQ(best[0].plausibility, 0.9);
  EXPECT_EQ(best[1].plausibility, 0.5);
  EXPECT_TRUE(best_of({}, 3, 0.1, 0.1).empty());
}

}  // namespace
}  // namespace augicp
