// SPDX-License-Identifier: MIT
#include "augicp/odometry/odometry.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>
#include <numbers>
#include <stop_token>

#include "augicp/core/error.h"
#include "augicp/geometry/rotation.h"
#include "augicp/testing/matchers.h"
#include "augicp/testing/rendering.h"
#include "augicp/testing/rolling_camera.h"
#include "augicp/testing/scenes.h"

namespace augicp {
namespace {

using testing::NearPose;

constexpr double kFramePeriod_s = 1.0 / 30.0;

const OdometryOptions& small_images() {
  static const OdometryOptions options = [] {
    OdometryOptions made;
    made.pixel_step = 1;
    made.registration.num_threads = 1;
    return made;
  }();
  return options;
}

// Where the camera is at frame k, in the frame of its first place: a walk along and a look around.
Rigid3 first_from_camera(double k) {
  return {rotation_exp({0.004 * k, 0.01 * k, 0.0}), {0.01 * k, 0.002 * k, 0.005 * k}};
}

Scan frame_at(const Rigid3& first_from_here, unsigned seed) {
  const testing::Scene room = testing::room();
  const Pinhole camera = testing::kinect_like_camera(120);
  DepthImage depth =
      testing::render(room, camera, camera.width, camera.height, room.world_from_camera * first_from_here).depth;
  testing::add_depth_noise(depth, testing::kKinectSigmaAt1m, seed);
  return prepare_frame(depth, {camera, {}}, small_images());
}

Scan frame(int k) { return frame_at(first_from_camera(k), static_cast<unsigned>(k + 1)); }

Scan black_frame() {
  const Pinhole camera = testing::kinect_like_camera(120);
  DepthImage none{camera.width, camera.height, {}};
  none.depth.assign(static_cast<std::size_t>(camera.width) * camera.height, std::numeric_limits<float>::quiet_NaN());
  return prepare_frame(none, {camera, {}}, small_images());
}

TEST(Odometry, FollowsACameraThroughARoom) {
  for (const Reference reference : {Reference::Model, Reference::PreviousFrame}) {
    OdometryOptions options = small_images();
    options.reference = reference;
    Odometry odometry(options);
    EXPECT_EQ(odometry.add(0.0, frame(0)).status, FrameStatus::Started);
    for (int k = 1; k < 25; ++k) {
      const FrameReport report = odometry.add(k * kFramePeriod_s, frame(k));
      EXPECT_EQ(report.status, FrameStatus::Tracked) << k;
      EXPECT_THAT(report.world_from_camera, NearPose(first_from_camera(k), 0.01, 0.03)) << k;
      EXPECT_EQ(report.segment, 0);
    }
  }
}

TEST(Odometry, MakesKeyframesAsTheViewChanges) {
  Odometry odometry(small_images());
  int num_keyframes = 0;
  for (int k = 0; k < 40; ++k) num_keyframes += odometry.add(k * kFramePeriod_s, frame(k)).is_keyframe;
  EXPECT_GE(num_keyframes, 2);
  EXPECT_LE(num_keyframes, 20);
}

// robustness 17: dropped frames. The motion between frames is five times what it was.
TEST(Odometry, BridgesDroppedFrames) {
  Odometry odometry(small_images());
  for (int k = 0; k < 25; ++k) {
    if (k >= 10 && k < 15) continue;
    const FrameReport report = odometry.add(k * kFramePeriod_s, frame(k));
    EXPECT_TRUE(has_pose(report.status)) << k;
    EXPECT_THAT(report.world_from_camera, NearPose(first_from_camera(k), 0.01, 0.02)) << k;
  }
}

// robustness 17: a 10 s gap. Nothing is made of the speed before it.
TEST(Odometry, GoesOnWhereItWasAfterALongGap) {
  Odometry odometry(small_images());
  for (int k = 0; k < 8; ++k) odometry.add(k * kFramePeriod_s, frame(k));
  const FrameReport report = odometry.add(10.0, frame(9));
  EXPECT_EQ(report.status, FrameStatus::Tracked);
  EXPECT_THAT(report.world_from_camera, NearPose(first_from_camera(9), 0.01, 0.02));
}

// robustness 17: black frames
TEST(Odometry, SkipsBlackFrames) {
  Odometry odometry(small_images());
  EXPECT_EQ(odometry.add(-1.0, black_frame()).status, FrameStatus::NoReadings);
  for (int k = 0; k < 12; ++k) {
    const bool is_black = k == 5 || k == 6;
    const FrameReport report = odometry.add(k * kFramePeriod_s, is_black ? black_frame() : frame(k));
    EXPECT_EQ(has_pose(report.status), !is_black) << k;
    if (is_black) continue;
    EXPECT_THAT(report.world_from_camera, NearPose(first_from_camera(k), 0.01, 0.02)) << k;
  }
}

// robustness 17: a jump of 180 degrees. What is seen then has nothing to do with the reference.
TEST(Odometry, LosesTheCameraInAJumpAndFindsItWhenItComesBack) {
  Odometry odometry(small_images());
  for (int k = 0; k < 5; ++k) odometry.add(k * kFramePeriod_s, frame(k));
  const Rigid3 turned{rotation_exp({0.0, std::numbers::pi, 0.0}), Vec3d::Zero()};
  for (int k = 5; k < 8; ++k)
    EXPECT_EQ(odometry.add(k * kFramePeriod_s, frame_at(first_from_camera(k) * turned, 50)).status, FrameStatus::Lost);
  const FrameReport back = odometry.add(8 * kFramePeriod_s, frame(8));
  EXPECT_EQ(back.status, FrameStatus::Tracked);
  EXPECT_EQ(back.segment, 0);
  EXPECT_THAT(back.world_from_camera, NearPose(first_from_camera(8), 0.01, 0.02));
}

// robustness 17: a jump for good. After a while a new segment begins, and the run goes on from there.
TEST(Odometry, StartsANewSegmentWhenTheCameraStaysLost) {
  OdometryOptions options = small_images();
  options.max_lost = 4;
  Odometry odometry(options);
  for (int k = 0; k < 3; ++k) odometry.add(k * kFramePeriod_s, frame(k));
  std::vector<FrameStatus> statuses;
  FrameReport last;
  // To where more than bare walls are in view: along these a motion is free.
  const Rigid3 turned{rotation_exp({-0.4, 1.0, 0.0}), Vec3d::Zero()};
  for (int k = 3; k < 12; ++k) {
    last = odometry.add(k * kFramePeriod_s, frame_at(first_from_camera(k) * turned, 60 + k));
    statuses.push_back(last.status);
  }
  using enum FrameStatus;
  EXPECT_THAT(statuses, ::testing::ElementsAre(Lost, Lost, Lost, Lost, Started, Tracked, Tracked, Tracked, Tracked));
  EXPECT_EQ(last.segment, 1);
  // Within the segment the motion is right.
  const Rigid3 world_from_restart = first_from_camera(2);
  const Rigid3 moved = inverse(first_from_camera(7) * turned) * (first_from_camera(11) * turned);
  EXPECT_THAT(last.world_from_camera, NearPose(world_from_restart * moved, 0.01, 0.02));
}

// robustness 17: two stamps almost equal. No speed is made of the moment between them, with or without a shutter.
TEST(Odometry, BearsStampsThatAlmostCoincide) {
  for (const double readout_s : {0.0, kFramePeriod_s}) {
    for (const int early : {1, 6}) {
      Odometry odometry(small_images(), readout_s);
      for (int k = 0; k < 10; ++k) {
        const double stamp_s = k == early ? (k - 1) * kFramePeriod_s + 1e-5 : k * kFramePeriod_s;
        const FrameReport report = odometry.add(stamp_s, frame(k));
        EXPECT_TRUE(has_pose(report.status)) << k;
        EXPECT_THAT(report.world_from_camera, NearPose(first_from_camera(k), 0.02, 0.04)) << k;
      }
    }
  }
}

TEST(Odometry, SaysWhyAFrameHasTooFewReadings) {
  Odometry odometry(small_images());
  EXPECT_THAT(odometry.add(0.0, black_frame()).problem, ::testing::HasSubstr("0 readings, at least"));
}

// robustness 17: repeated or out-of-order frames
TEST(Odometry, IgnoresFramesOutOfOrder) {
  Odometry odometry(small_images());
  for (int k = 0; k < 6; ++k) odometry.add(k * kFramePeriod_s, frame(k));
  EXPECT_EQ(odometry.add(5 * kFramePeriod_s, frame(5)).status, FrameStatus::OutOfOrder);
  const FrameReport early = odometry.add(2 * kFramePeriod_s, frame(2));
  EXPECT_EQ(early.status, FrameStatus::OutOfOrder);
  EXPECT_THAT(early.problem, ::testing::HasSubstr("is not after " + std::to_string(5 * kFramePeriod_s) + " s"));
  const FrameReport never = odometry.add(std::numeric_limits<double>::quiet_NaN(), frame(6));
  EXPECT_EQ(never.status, FrameStatus::OutOfOrder);
  EXPECT_EQ(never.problem, "its stamp is not finite");
  const FrameReport next = odometry.add(6 * kFramePeriod_s, frame(6));
  EXPECT_EQ(next.status, FrameStatus::Tracked);
  EXPECT_THAT(next.world_from_camera, NearPose(first_from_camera(6), 0.01, 0.02));
}

// robustness 17: the same image under new stamps, as some recorders write if the sensor gave none.
TEST(Odometry, StandsStillOverRepeatedImages) {
  Odometry odometry(small_images());
  for (int k = 0; k < 6; ++k) odometry.add(k * kFramePeriod_s, frame(k));
  const Scan same = frame(5);
  for (int k = 6; k < 9; ++k) {
    const FrameReport report = odometry.add(k * kFramePeriod_s, same);
    EXPECT_EQ(report.status, FrameStatus::Tracked);
    EXPECT_THAT(report.world_from_camera, NearPose(first_from_camera(5), 0.01, 0.02));
  }
}

// A fast camera with a rolling shutter: every row is rendered from the camera's place at that time.
Scan skewed_frame(int k, double readout_s) {
  const testing::Scene room = testing::room();
  const Pinhole camera = testing::kinect_like_camera(80);
  DepthImage image{camera.width, camera.height, {}};
  for (int v = 0; v < camera.height; ++v) {
    const double at = 3.0 * (k + ((v + 0.5) / camera.height - 0.5) * readout_s / kFramePeriod_s);
    const std::vector<float> row = testing::render_row(room, camera, v, room.world_from_camera * first_from_camera(at));
    image.depth.insert(image.depth.end(), row.begin(), row.end());
  }
  return prepare_frame(image, {camera, {}}, small_images());
}

TEST(Odometry, AllowingForTheRollingShutterRemovesMostOfItsError) {
  double error[2] = {};
  for (const bool allowed_for : {false, true}) {
    Odometry odometry(small_images(), allowed_for ? kFramePeriod_s : 0.0);
    for (int k = 0; k < 8; ++k) {
      const FrameReport report = odometry.add(k * kFramePeriod_s, skewed_frame(k, kFramePeriod_s));
      ASSERT_TRUE(has_pose(report.status));
      error[allowed_for] += angle_between(report.world_from_camera, first_from_camera(3.0 * k));
    }
  }
  EXPECT_LT(error[true], 0.6 * error[false]);
}

TEST(Odometry, RefusesOptionsOutOfTheirRange) {
  OdometryOptions options;
  options.min_overlap = 1.5;
  EXPECT_THROW(Odometry{options}, std::invalid_argument);
  options = {};
  options.max_lost = 0;
  EXPECT_THROW(Odometry{options}, std::invalid_argument);
  options = {};
  options.pixel_step = -1;
  EXPECT_THROW(Odometry{options}, std::invalid_argument);
  options = {};
  options.range.max = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(Odometry{options}, std::invalid_argument);
  EXPECT_THROW((Odometry{{}, -1.0}), std::invalid_argument);
}

TEST(Odometry, AFrameThatContradictsTheModelIsMarkedAndNotMerged) {
  OdometryOptions options = small_images();
  options.max_strain = 1e-6;  // a limit that no frame meets
  options.max_lost = 3;
  Odometry odometry(options);
  odometry.add(0.0, frame(0));
  for (int k = 1; k <= 3; ++k) {
    const FrameReport report = odometry.add(k * kFramePeriod_s, frame(k));
    EXPECT_EQ(report.status, FrameStatus::Doubtful) << k;
    EXPECT_TRUE(has_pose(report.status));
    EXPECT_FALSE(report.is_keyframe);
    EXPECT_GT(report.strain, 0.0);
  }
  const FrameReport next = odometry.add(4 * kFramePeriod_s, frame(4));
  EXPECT_EQ(next.status, FrameStatus::Started);
  EXPECT_EQ(next.segment, 1);
}

TEST(OdometryInterrupted, IsAsItWasBefore) {
  Odometry interrupted(small_images()), other(small_images());
  std::stop_source stop;
  stop.request_stop();
  for (int k = 0; k < 4; ++k) {
    EXPECT_THROW(interrupted.add(k * kFramePeriod_s, frame(k), stop.get_token()), Interrupted);
    const FrameReport report = interrupted.add(k * kFramePeriod_s, frame(k));
    const FrameReport expected = other.add(k * kFramePeriod_s, frame(k));
    EXPECT_EQ(report.status, expected.status);
    EXPECT_EQ(report.world_from_camera.matrix(), expected.world_from_camera.matrix());
  }
}

// As in the lists of frames.
TEST(FrameStatus, EveryOneHasItsName) {
  const std::pair<FrameStatus, const char*> names[] = {{FrameStatus::Started, "started"},
                                                       {FrameStatus::Tracked, "tracked"},
                                                       {FrameStatus::Degenerate, "degenerate"},
                                                       {FrameStatus::Doubtful, "doubtful"},
                                                       {FrameStatus::Lost, "lost"},
                                                       {FrameStatus::NoReadings, "no_readings"},
                                                       {FrameStatus::OutOfOrder, "out_of_order"},
                                                       {FrameStatus::Unreadable, "unreadable"}};
  for (const auto& [status, name] : names) EXPECT_EQ(name_of(status), name);
}

}  // namespace
}  // namespace augicp
