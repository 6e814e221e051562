// SPDX-License-Identifier: MIT
#include "augicp/eval/matched_poses.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <stdexcept>
#include <string>

#include "augicp/eval/trajectory_testing.h"
#include "augicp/testing/matchers.h"

namespace augicp {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using testing::kStart_s;
using testing::NearPose;
using testing::wandering;

Trajectory with_stamps(Trajectory trajectory, double from_s, double factor) {
  for (StampedPose& pose : trajectory) pose.stamp_s = factor * (pose.stamp_s - from_s);
  return trajectory;
}

std::string refusal(const Trajectory& estimate, const Trajectory& truth, const AssociationOptions& options = {}) {
  try {
    match_poses(estimate, truth, options);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "";
}

TEST(MatchedPoses, KeepWhatBothSaidOfTheMoment) {
  const Trajectory truth = wandering(100.0), estimate = testing::disturbed(wandering(30.0));
  const auto poses = match_poses(estimate, truth);
  ASSERT_EQ(poses.size(), estimate.size());
  for (std::size_t i = 0; i < poses.size(); ++i) {
    EXPECT_EQ(poses[i].stamp_s, estimate[i].stamp_s);
    EXPECT_THAT(poses[i].estimate, NearPose(estimate[i].world_from_camera, 0.0, 0.0));
    EXPECT_THAT(poses[i].truth, NearPose(testing::wandering_pose(estimate[i].stamp_s - kStart_s), 0.01, 0.01));
  }
}

TEST(MatchedPoses, InterpolatedTruthIsNearerThanTheNearest) {
  const Trajectory truth = wandering(100.0), estimate = wandering(30.0);
  double nearest_m = 0.0, interpolated_m = 0.0;
  for (const MatchedPose& pose : match_poses(estimate, truth))
    nearest_m = std::max(nearest_m, (pose.truth.translation - pose.estimate.translation).norm());
  for (const MatchedPose& pose : match_poses(estimate, truth, {}, TruthReading::Interpolated))
    interpolated_m = std::max(interpolated_m, (pose.truth.translation - pose.estimate.translation).norm());
  EXPECT_GT(nearest_m, 1e-3);
  EXPECT_LT(interpolated_m, 1e-5);
}

TEST(MatchedPoses, TruthIsNotInterpolatedOverAGap) {
  const Trajectory truth = {{0.0, {}}, {0.04, {}}, {0.0801, {}}}, estimate = {{0.01, {}}, {0.05, {}}};
  EXPECT_EQ(match_poses(estimate, truth, {}, TruthReading::Interpolated).size(), 1u);
}

TEST(MatchedPoses, MayBeFewWhereTheTruthIsShort) {
  EXPECT_EQ(match_poses(wandering(30.0, 50.0), wandering(100.0, 1.0)).size(), 31u);  // two 10 ms or less behind its end
}

TEST(MatchedPoses, WithoutACommonStampSaysBothSpans) {
  Trajectory later = with_stamps(wandering(30.0), -100.0, 1.0);
  EXPECT_THAT(refusal(later, wandering()),
              AllOf(HasSubstr("no common timestamps within 0.020000 s"),
                    HasSubstr("the estimate spans 1305031552.000000 .. 1305031556.966667 s"),
                    HasSubstr("the truth spans 1305031452.000000 .. 1305031456.966667 s"), HasSubstr("time offset?")));
  for (const TruthReading reading : {TruthReading::Nearest, TruthReading::Interpolated}) {
    const auto poses = match_poses(later, wandering(), {.time_offset_s = -100.0}, reading);
    EXPECT_GE(poses.size(), 148u);  // of 150; rounding may put the first or last outside
    EXPECT_NEAR(poses.front().stamp_s, kStart_s, 0.04);
  }
  EXPECT_THAT(refusal({}, wandering()), HasSubstr("the estimate has no poses"));
  EXPECT_THAT(refusal(wandering(), {}), HasSubstr("the truth has no poses"));
}

// robustness 8
TEST(MatchedPoses, MillisecondsInsteadOfSecondsAreSeen) {
  const std::pair<double, const char*> units[] = {{1e3, "milliseconds"}, {1e6, "microseconds"}, {1e9, "nanoseconds"}};
  const Trajectory truth = wandering(100.0), estimate = wandering(30.0);
  for (const auto& [factor, name] : units) {
    const std::string of_estimate = std::string("stamps of the estimate are ") + name;
    EXPECT_THAT(refusal(with_stamps(estimate, 0.0, factor), truth), HasSubstr(of_estimate));
    EXPECT_THAT(refusal(estimate, with_stamps(truth, 0.0, factor)),
                HasSubstr(std::string("stamps of the truth are ") + name));
    // Also if both begin at 0, so that the first poses match by chance.
    const std::string of_both = refusal(with_stamps(estimate, kStart_s, factor), with_stamps(truth, kStart_s, 1.0));
    EXPECT_THAT(of_both, AllOf(HasSubstr("only "), HasSubstr(of_estimate)));
    // And if the clocks differ too, so that only the durations show it.
    EXPECT_THAT(refusal(with_stamps(estimate, kStart_s, factor), truth),
                HasSubstr(std::string("are the estimate's in ") + name));
    EXPECT_THAT(refusal(estimate, with_stamps(truth, kStart_s, factor)),
                HasSubstr(std::string("are the truth's in ") + name));
  }
}

// Ten frames far apart, half of them within the truth: in milliseconds all ten would meet the dense truth by chance.
TEST(MatchedPoses, HalfTheEstimateOutsideADenseTruthIsNoWrongUnit) {
  Trajectory truth, estimate;
  for (int i = 0; i < 40000; ++i) truth.push_back({1e-3 * i, {}});
  for (int i = 0; i < 10; ++i) estimate.push_back({10.0 * i, {}});
  EXPECT_EQ(match_poses(estimate, truth).size(), 5u);
}

TEST(MatchedPoses, StampsMustIncrease) {
  const Trajectory unordered = {{1.0, {}}, {0.5, {}}};
  EXPECT_THAT(refusal(unordered, wandering()), HasSubstr("stamps that increase"));
  EXPECT_THAT(refusal(wandering(), unordered), HasSubstr("stamps that increase"));
}

}  // namespace
}  // namespace augicp
