// SPDX-License-Identifier: MIT
#include "augicp/eval/evaluate.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <numbers>
#include <stdexcept>

#include "augicp/eval/trajectory_testing.h"
#include "augicp/testing/matchers.h"

namespace augicp {
namespace {

using testing::disturbed;
using testing::moved;
using testing::wandering;

const Rigid3 kElsewhere{rotation_exp({0.5, -1.0, 2.0}), {4.0, -7.0, 1.5}};

void expect_near(const Statistics& a, const Statistics& b, double tolerance = 1e-9) {
  EXPECT_EQ(a.count, b.count);
  for (const auto field : {&Statistics::rmse, &Statistics::mean, &Statistics::median, &Statistics::std,
                           &Statistics::min, &Statistics::max})
    EXPECT_NEAR(a.*field, b.*field, tolerance);
}

void expect_near(const PoseStatistics& a, const PoseStatistics& b, double tolerance = 1e-9) {
  expect_near(a.translation, b.translation, tolerance);
  expect_near(a.rotation, b.rotation, tolerance);
}

// All errors are this number.
void expect_all(const Statistics& statistics, double value, double tolerance = 1e-9) {
  expect_near(statistics, {statistics.count, value, value, value, 0.0, value, value, 0.0}, tolerance);
}

Evaluation evaluate_with(const Trajectory& estimate, const Trajectory& truth, Alignment alignment) {
  return evaluate(estimate, truth, {.alignment = alignment});
}

TEST(Evaluate, OfTheTruthItselfIsZero) {
  const Trajectory truth = wandering();
  const Evaluation evaluation = evaluate(truth, truth);
  for (const PoseStatistics& errors : {evaluation.absolute, *evaluation.aligned, *evaluation.relative}) {
    expect_all(errors.translation, 0.0);
    expect_all(errors.rotation, 0.0);
  }
  EXPECT_EQ(evaluation.num_matched, truth.size());
  EXPECT_EQ(evaluation.matched_share, 1.0);
  EXPECT_EQ(evaluation.first_stamp_s, truth.front().stamp_s);
  EXPECT_EQ(evaluation.last_stamp_s, truth.back().stamp_s);
}

TEST(Evaluate, PureOffsetIsSeenOnlyWithoutAlignment) {
  const Trajectory truth = wandering();
  const Evaluation evaluation = evaluate(moved({Eigen::Quaterniond::Identity(), {0.3, 0.0, -0.4}}, truth), truth);
  expect_all(evaluation.absolute.translation, 0.5);
  expect_all(evaluation.absolute.rotation, 0.0);
  for (const PoseStatistics& errors : {*evaluation.aligned, *evaluation.relative}) {
    expect_all(errors.translation, 0.0);
    expect_all(errors.rotation, 0.0);
  }
}

TEST(Evaluate, CameraTurnedInItsPlaceIsARotationErrorOnly) {
  const Trajectory truth = wandering();
  Trajectory turned = truth;
  for (StampedPose& pose : turned) pose.world_from_camera.rotation *= rotation_exp({0.0, 0.1, 0.0});
  const Evaluation evaluation = evaluate(turned, truth);
  for (const PoseStatistics& errors : {evaluation.absolute, *evaluation.aligned}) {
    expect_all(errors.translation, 0.0);
    expect_all(errors.rotation, 0.1);
  }
  EXPECT_GT(evaluation.relative->translation.rmse, 1e-4) << "steps point elsewhere in a camera that is turned";
}

TEST(Evaluate, IsUnchangedWhenBothWorldsMove) {
  const Trajectory truth = wandering(), estimate = disturbed(truth);
  const Evaluation here = evaluate(estimate, truth);
  const Evaluation there = evaluate(moved(kElsewhere, estimate), moved(kElsewhere, truth));
  expect_near(there.absolute, here.absolute);
  expect_near(*there.aligned, *here.aligned);
  expect_near(*there.relative, *here.relative);
}

TEST(Evaluate, AlignedAndRelativeErrorsAreUnchangedWhenOneWorldMoves) {
  const Trajectory truth = wandering(), estimate = disturbed(truth);
  for (const Alignment alignment : {Alignment::Origin, Alignment::Rigid, Alignment::Similarity}) {
    const Evaluation here = evaluate_with(estimate, truth, alignment);
    for (const Evaluation& there : {evaluate_with(moved(kElsewhere, estimate), truth, alignment),
                                    evaluate_with(estimate, moved(kElsewhere, truth), alignment)}) {
      expect_near(*there.aligned, *here.aligned);
      expect_near(*there.relative, *here.relative);
      EXPECT_GT(there.absolute.translation.rmse, 1.0);
    }
  }
}

TEST(Evaluate, AlignmentLeadsFromTheEstimatesWorldToTheTrue) {
  const Trajectory truth = wandering();
  for (const Alignment alignment : {Alignment::Origin, Alignment::Rigid, Alignment::Similarity}) {
    const RigidFit fit = evaluate_with(truth, moved(kElsewhere, truth), alignment).alignment;
    EXPECT_THAT(fit.target_from_source.motion, testing::NearPose(kElsewhere, 1e-9, 1e-9));
    EXPECT_TRUE(fit.unique);
  }
  const Evaluation none = evaluate_with(truth, moved(kElsewhere, truth), Alignment::None);
  EXPECT_THAT(none.alignment.target_from_source.motion, testing::NearPose(Rigid3{}, 0.0, 0.0));
  EXPECT_FALSE(none.aligned);
}

TEST(Evaluate, OriginAlignmentMakesTheFirstErrorZero) {
  const Trajectory truth = wandering();
  const Evaluation evaluation = evaluate_with(moved(kElsewhere, disturbed(truth)), truth, Alignment::Origin);
  EXPECT_NEAR(evaluation.aligned->translation.min, 0.0, 1e-9);
  EXPECT_NEAR(evaluation.aligned->rotation.min, 0.0, 1e-9);
}

TEST(Evaluate, RigidAlignmentHasTheLeastErrorOfPositions) {
  const Trajectory truth = wandering(), estimate = disturbed(truth, 0.02, 0.2);
  const double least = evaluate(estimate, truth).aligned->translation.rmse;
  EXPECT_LT(least, evaluate(estimate, truth).absolute.translation.rmse);
  EXPECT_LT(least, evaluate_with(estimate, truth, Alignment::Origin).aligned->translation.rmse);
  EXPECT_GT(least, evaluate_with(estimate, truth, Alignment::Similarity).aligned->translation.rmse);
}

TEST(Evaluate, SimilarityAlignmentRecoversTheScaleForAllErrors) {
  const Trajectory truth = wandering();
  Trajectory small = moved(kElsewhere, truth);
  for (StampedPose& pose : small) pose.world_from_camera.translation *= 0.25;
  const Evaluation evaluation = evaluate_with(small, truth, Alignment::Similarity);
  EXPECT_NEAR(evaluation.alignment.target_from_source.scale, 4.0, 1e-9);
  expect_all(evaluation.aligned->translation, 0.0);
  expect_all(evaluation.relative->translation, 0.0);
  EXPECT_GT(evaluate(small, truth).relative->translation.rmse, 0.01);
}

// A camera that goes straight ahead by a metre a frame, and an estimate that rotates by 0.1 rad a frame.
TEST(Evaluate, RelativeErrorOfASteadyTurn) {
  Trajectory truth, estimate;
  const Rigid3 step{Eigen::Quaterniond::Identity(), {0, 0, 1}}, turning_step{rotation_exp({0, 0.1, 0}), {0, 0, 1}};
  Rigid3 true_pose, estimated_pose;
  for (int i = 0; i < 10; ++i) {
    truth.push_back({1.0 * i, true_pose});
    estimate.push_back({1.0 * i, estimated_pose});
    true_pose = true_pose * step;
    estimated_pose = estimated_pose * turning_step;
  }
  const PoseStatistics one = *evaluate(estimate, truth).relative;
  EXPECT_EQ(one.translation.count, 9u);
  expect_all(one.translation, 0.0);
  expect_all(one.rotation, 0.1);
  // Two steps: the second metre points 0.1 rad aside.
  const PoseStatistics two = *evaluate(estimate, truth, {.delta = {.delta = 2}}).relative;
  expect_all(two.translation, 2.0 * std::sin(0.05));
  expect_all(two.rotation, 0.2);
}

TEST(Evaluate, MissingPosesAndOtherRatesAreLeftOut) {
  const Trajectory truth = wandering(100.0, 5.0);
  Trajectory estimate;
  for (const StampedPose& pose : moved(kElsewhere, wandering(20.0, 8.0)))  // from 5 s on there is no truth
    if (std::lround((pose.stamp_s - testing::kStart_s) * 20.0) % 7 != 3) estimate.push_back(pose);
  const Evaluation evaluation = evaluate(estimate, truth);
  EXPECT_EQ(evaluation.num_estimate, 137u);
  EXPECT_EQ(evaluation.num_truth, 500u);
  EXPECT_EQ(evaluation.num_matched, 87u);  // 0 .. 99 without 14, and 5.00 s, 10 ms behind the truth's end
  EXPECT_NEAR(evaluation.matched_share, 87.0 / 137.0, 1e-15);
  EXPECT_LT(evaluation.aligned->translation.max, 0.02);
}

TEST(Evaluate, WithoutAPairAtDeltaThereIsNoRelativeError) {
  const Trajectory truth = wandering();
  EXPECT_FALSE(evaluate(truth, truth, {.delta = {.delta = 1e6}}).relative);
  EXPECT_FALSE(evaluate({truth[3]}, truth).relative);
}

TEST(Evaluate, OfPosesOnALineSaysThatTheAlignmentIsNotUnique) {
  Trajectory straight = wandering();
  for (StampedPose& pose : straight) pose.world_from_camera.translation.head<2>() = Eigen::Vector2d(1, 2);
  const Evaluation evaluation = evaluate(moved(kElsewhere, straight), straight);
  EXPECT_FALSE(evaluation.alignment.unique);
  expect_all(evaluation.aligned->translation, 0.0);
}

TEST(Evaluate, WhatCannotBeComparedIsRefused) {
  const Trajectory truth = wandering();
  Trajectory far = truth;
  far[3].world_from_camera.translation.x() = 1e200;
  EXPECT_THROW(evaluate(far, truth), std::invalid_argument);
  EXPECT_THROW(evaluate({}, truth), std::invalid_argument);
  EXPECT_THROW(evaluate(truth, {}), std::invalid_argument);
  EXPECT_THROW(evaluate(truth, truth, {.delta = {.delta = 0.5}}), std::invalid_argument);
  EXPECT_THROW(evaluate(truth, truth, {.association = {.max_difference_s = -1.0}}), std::invalid_argument);
}

}  // namespace
}  // namespace augicp
