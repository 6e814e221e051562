// SPDX-License-Identifier: MIT
#include "augicp/eval/segment_errors.h"

#include <gtest/gtest.h>

#include <stdexcept>

#include "augicp/geometry/rotation.h"

namespace augicp {
namespace {

// A metre a pose along x, stretched by a factor, turning by an angle a metre about z.
std::vector<Rigid3> path(std::size_t count, double stretch, double turn_rad = 0.0) {
  std::vector<Rigid3> poses;
  for (std::size_t i = 0; i < count; ++i) {
    const auto s = static_cast<double>(i);
    poses.push_back({rotation_exp({0.0, 0.0, turn_rad * s}), {stretch * s, 0.0, 0.0}});
  }
  return poses;
}

TEST(SegmentErrors, AStretchedPathErrsByItsStretch) {
  const SegmentErrors errors = segment_errors(path(60, 1.0), path(60, 1.02), {{10.0, 20.0, 500.0}, 10});
  ASSERT_EQ(errors.of_length.size(), 2u);  // no segment of 500 m
  EXPECT_EQ(errors.of_length[0].num_segments, 5u);
  EXPECT_EQ(errors.of_length[1].num_segments, 4u);
  // A segment of 10 m ends at the first pose beyond it, after 11 m.
  EXPECT_NEAR(errors.of_length[0].translation, 0.02 * 11.0 / 10.0, 1e-12);
  EXPECT_NEAR(errors.of_length[1].translation, 0.02 * 21.0 / 20.0, 1e-12);
  EXPECT_NEAR(errors.all.translation, (5 * 0.022 + 4 * 0.021) / 9, 1e-12);
  EXPECT_EQ(errors.all.num_segments, 9u);
  EXPECT_EQ(errors.all.rotation, 0.0);
}

TEST(SegmentErrors, ATurnErrsByItsAngleAMetre) {
  const SegmentErrors errors = segment_errors(path(60, 1.0), path(60, 1.0, 1e-3), {{10.0}, 1});
  EXPECT_NEAR(errors.all.rotation, 1e-3 * 11.0 / 10.0, 1e-9);
}

TEST(SegmentErrors, DoNotDependOnTheWorlds) {
  const Rigid3 other{rotation_exp({0.3, -1.0, 0.2}), {5.0, 6.0, 7.0}};
  std::vector<Rigid3> moved = path(60, 1.02);
  for (Rigid3& pose : moved) pose = other * pose;
  const SegmentOptions options{{10.0}, 10};
  EXPECT_NEAR(segment_errors(path(60, 1.0), moved, options).all.translation,
              segment_errors(path(60, 1.0), path(60, 1.02), options).all.translation, 1e-12);
}

TEST(SegmentErrors, OddInputsAreRefused) {
  EXPECT_THROW(segment_errors(path(3, 1.0), path(4, 1.0)), std::invalid_argument);
  EXPECT_THROW(segment_errors(path(3, 1.0), path(3, 1.0), {{0.0}, 1}), std::invalid_argument);
  EXPECT_THROW(segment_errors(path(3, 1.0), path(3, 1.0), {{1.0}, 0}), std::invalid_argument);
  EXPECT_EQ(segment_errors({}, {}).all.num_segments, 0u);
}

}  // namespace
}  // namespace augicp
