// SPDX-License-Identifier: MIT
#include "augicp/eval/coverage.h"

#include <gtest/gtest.h>

#include "augicp/eval/evaluate.h"
#include "augicp/eval/trajectory_testing.h"

namespace augicp {
namespace {

using testing::wandering;

// Without the poses from first to before last.
Trajectory without(Trajectory trajectory, std::ptrdiff_t first, std::ptrdiff_t last) {
  trajectory.erase(trajectory.begin() + first, trajectory.begin() + last);
  return trajectory;
}

Coverage coverage(const Trajectory& estimate, const Trajectory& truth, const EvaluationOptions& options = {}) {
  return evaluate(estimate, truth, options).coverage;
}

TEST(Coverage, OfTheTruthItselfIsWhole) {
  const Coverage found = coverage(wandering(), wandering());
  EXPECT_EQ(found.num_outside + found.num_unmatched + found.num_holes + found.num_missing, 0u);
  EXPECT_EQ(found.longest_hole_s, 0.0);
}

TEST(Coverage, HolesOfTheEstimateAreCounted) {
  const Trajectory truth = wandering(30.0);
  const Coverage found = coverage(without(without(truth, 100, 101), 20, 25), truth);
  EXPECT_EQ(found.num_holes, 2u);
  EXPECT_EQ(found.num_missing, 6u);
  EXPECT_NEAR(found.longest_hole_s, 6.0 / 30.0, 1e-6);
  EXPECT_EQ(found.num_outside + found.num_unmatched, 0u);
}

TEST(Coverage, HolesOfTheTruthLeavePosesUnmatched) {
  const Trajectory estimate = wandering(30.0);
  const Coverage found = coverage(estimate, without(estimate, 40, 47));
  EXPECT_EQ(found.num_unmatched, 7u);
  EXPECT_EQ(found.num_outside + found.num_holes, 0u);
}

TEST(Coverage, PosesBeforeAndAfterTheTruthAreOutside) {
  const Trajectory estimate = wandering(30.0, 5.0), truth = without(without(estimate, 140, 150), 0, 30);
  EXPECT_EQ(coverage(estimate, truth).num_outside, 40u);
  EXPECT_EQ(coverage(estimate, truth).num_unmatched, 0u);
  // Three of them come within reach at the front, and three more are outside at the end.
  EXPECT_EQ(coverage(estimate, truth, {.association = {.time_offset_s = 0.1}}).num_outside, 40u);
  // At the ends one pose each is as near as the tolerance.
  const EvaluationOptions wide{.association = {.max_difference_s = 0.034}, .truth = TruthReading::Nearest};
  EXPECT_EQ(coverage(estimate, truth, wide).num_outside, 38u);
  const EvaluationOptions between{.association = {.max_difference_s = 0.034}, .truth = TruthReading::Interpolated};
  EXPECT_EQ(coverage(estimate, truth, between).num_outside, 40u);
}

}  // namespace
}  // namespace augicp
