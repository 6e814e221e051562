// SPDX-License-Identifier: MIT
#include "augicp/experiment/sequence_errors.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "augicp/experiment/random.h"
#include "augicp/experiment/time_offset.h"
#include "augicp/geometry/rotation.h"

namespace augicp {
namespace {

// A camera with a changing rotation; poses every 10 ms from 0 to 5 s.
Rigid3 world_from_camera(double stamp_s) {
  const Vec3d turn(std::sin(2.0 * stamp_s), std::cos(3.0 * stamp_s), 0.5 * std::sin(stamp_s));
  return {rotation_exp(0.5 * turn), Vec3d(stamp_s, 0.0, 0.0)};
}

Trajectory turning_truth() {
  Trajectory truth;
  for (int i = 0; i <= 500; ++i) truth.push_back({0.01 * i, world_from_camera(0.01 * i)});
  return truth;
}

// Pairs a thirtieth of a second apart, registered up to noise by one whose clock is late.
std::vector<SequenceCurve> late_curves(double offset_s, double noise_rad) {
  std::mt19937 generator(5);
  std::vector<SequenceCurve> curves;
  for (int i = 0; i < 100; ++i) {
    SequenceCurve curve;
    curve.target = static_cast<std::size_t>(i);
    curve.source = curve.target + 1;
    curve.target_stamp_s = 0.3 + 0.04 * i;
    curve.source_stamp_s = curve.target_stamp_s + 1.0 / 30.0;
    const Rigid3 motion = inverse(world_from_camera(curve.target_stamp_s + offset_s)) *
                          world_from_camera(curve.source_stamp_s + offset_s);
    curve.path = {Rigid3{}, motion * random_motion(generator, noise_rad * gaussian(generator), 0.0)};
    curves.push_back(curve);
  }
  return curves;
}

TEST(TimeOffset, IsFoundFromRotations) {
  for (const double offset_s : {-0.022, 0.0, 0.06}) {
    const TimeOffset found = find_time_offset(late_curves(offset_s, 1e-3), turning_truth());
    EXPECT_NEAR(found.offset_s, offset_s, 2e-3);
    EXPECT_LT(found.spread_s, 8e-3);
    EXPECT_EQ(found.num_pairs, 100u);
    EXPECT_LE(found.median_rotation, found.median_rotation_at_0);
  }
}

// Else a table's rows would be measured against different truths.
TEST(TimeOffset, IsFoundByTheSameRegistrationsWhateverIsUnderTest) {
  SequenceOptions options;
  options.registration.lever = 0.2;
  options.registration.classifier = Classifier::Eigenvalues;
  options.registration.num_threads = 3;
  const RegistrationOptions found = time_offset_options(options).registration;
  EXPECT_FALSE(found.lever || found.classifier);
  EXPECT_EQ(found.num_threads, 3);
}

TEST(TimeOffset, OfTooFewPairsIsRefused) {
  auto curves = late_curves(0.0, 0.0);
  curves.resize(8);
  EXPECT_THROW(find_time_offset(curves, turning_truth()), std::invalid_argument);
}

TEST(Summary, TellsErrorsOfGuessAndResult) {
  const auto rows = summarize(late_curves(0.0, 0.0), turning_truth(), 0.0);
  ASSERT_EQ(rows.size(), 2u);
  EXPECT_NEAR(rows[0].translation.mean, 1.0 / 30.0, 1e-4);
  EXPECT_DOUBLE_EQ(rows[0].success_narrow, 0.0);  // 3 cm
  EXPECT_NEAR(rows[1].translation.p90, 0.0, 1e-3);
  EXPECT_DOUBLE_EQ(rows[1].success, 1.0);
}

TEST(Summary, LeavesOutPairsWithoutTruth) {
  auto curves = late_curves(0.0, 0.0);
  curves[3].source_stamp_s = 7.0;
  EXPECT_EQ(summarize(curves, turning_truth(), 0.0).front().num_pairs, 99u);
  EXPECT_TRUE(summarize(curves, {}, 0.0).empty());
}

TEST(ChosenTargets, AreSpreadOverThoseWithEverySource) {
  SequenceOptions options;
  options.gaps = {1, 5};
  EXPECT_EQ(chosen_targets(8, options), (std::vector<std::size_t>{0, 1, 2}));
  options.max_targets = 2;
  EXPECT_EQ(chosen_targets(8, options), (std::vector<std::size_t>{0, 2}));
  options.max_targets = 0;
  options.every = 2;
  EXPECT_EQ(chosen_targets(10, options), (std::vector<std::size_t>{0, 2, 4}));
  EXPECT_THROW(chosen_targets(5, options), std::invalid_argument);
}

}  // namespace
}  // namespace augicp
