// SPDX-License-Identifier: MIT
// LidarOdometry across gaps in a recording. The same with more seeds and lengths:
// experiments/odometry/lidar_pauses.cpp.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <numbers>
#include <ostream>
#include <string>

#include "augicp/geometry/rotation.h"
#include "augicp/odometry/lidar_odometry.h"
#include "augicp/odometry/lidar_testing.h"
#include "augicp/synthetic/lidar.h"
#include "augicp/synthetic/outdoor_scenes.h"
#include "augicp/testing/matchers.h"
#include "augicp/testing/repeats.h"
#include "augicp/testing/scenes.h"

namespace augicp {
namespace {

using testing::kSweep_s;
using testing::NearPose;
using testing::one_thread;
using testing::small_lidar;

constexpr double kSpeed = 6.0, kBraking = 7.0;
constexpr int kNumBefore = 5, kNumAfter = 4;
constexpr double kPause_s = kNumBefore * kSweep_s;

// The distance that the sensor has driven. It brakes when the recording pauses.
double braked(double time_s) {
  const double t = std::clamp(time_s - kPause_s, 0.0, kSpeed / kBraking);
  return kSpeed * std::min(time_s, kPause_s) + kSpeed * t - 0.5 * kBraking * t * t;
}

struct Pause {
  std::string name;
  double gap_s;
  std::function<double(double time_s, double gap_s)> distance;
  double rotation = 0.0;        // during the pause, radians
  bool is_clock_alone = false;  // the stamps jump, the sensor drives on
};

std::ostream& operator<<(std::ostream& stream, const Pause& pause) { return stream << pause.name; }

double driving(double time_s, double) { return kSpeed * time_s; }
double stopping(double time_s, double) { return braked(time_s); }
double starting_again(double time_s, double gap_s) {
  return braked(time_s) + kSpeed * std::max(0.0, time_s - kPause_s - gap_s);
}

class LidarPauses : public ::testing::TestWithParam<Pause> {
 protected:
  Rigid3 place_at(double time_s) const {
    const double turned = std::clamp((time_s - kPause_s) / GetParam().gap_s, 0.0, 1.0) * GetParam().rotation;
    return {rotation_exp({0.0, 0.0, turned}), {GetParam().distance(time_s, GetParam().gap_s), 0.0, 0.0}};
  }
};

// Without a search, except where the sensor has rotated: it costs a second, and hides what the starts are worth.
// Whether the sensor moves during the first sweep after the gap is not known, so that this one may be Degenerate.
TEST_P(LidarPauses, TheSensorIsFoundAgain) {
  for (const unsigned seed : testing::cases({11u, 12u}, 1)) {
    const testing::Scene street = synthetic::street(seed);
    const synthetic::Motion motion = [&](double time_s) { return street.world_from_camera * place_at(time_s); };
    LidarOptions options = one_thread();
    options.search = GetParam().rotation != 0.0;
    LidarOdometry odometry(options);
    for (int k = 0; k < kNumBefore + kNumAfter; ++k) {
      const double stamp_s = k * kSweep_s + (k < kNumBefore ? 0.0 : GetParam().gap_s);
      const double begin_s = GetParam().is_clock_alone ? k * kSweep_s : stamp_s;
      const synthetic::Sweep sweep =
          synthetic::scan({street, {}}, small_lidar(), motion, static_cast<unsigned>(k + 1), begin_s);
      const FrameReport report = odometry.add(stamp_s, sweep.cloud, shares_from_times(sweep.times_s));
      const Rigid3 true_one = inverse(place_at(0.5 * kSweep_s)) * place_at(begin_s + 0.5 * kSweep_s);
      const bool is_first = k == kNumBefore;
      if (k > 0 && !is_first) {
        EXPECT_EQ(report.status, FrameStatus::Tracked) << "seed " << seed << " sweep " << k;
      }
      EXPECT_TRUE(has_pose(report.status));
      EXPECT_THAT(report.world_from_camera, NearPose(true_one, 0.006, is_first ? 0.12 : 0.05))
          << "seed " << seed << " sweep " << k;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(, LidarPauses,
                         ::testing::Values(Pause{"DrivesOn", 1.0, driving}, Pause{"StopsForASecond", 1.0, stopping},
                                           Pause{"StopsForAMinute", 60.0, stopping},
                                           Pause{"StartsAgain", 10.0, starting_again},
                                           Pause{"Rotates", 10.0, stopping, 1.0},
                                           Pause{"TheClockJumps", 60.0, driving, 0.0, true}),
                         [](const auto& tested) { return tested.param.name; });

// Thrown about in a room, by up to 70 degrees and 1 m a scan. The usual share of points on surfaces falls with the
// scans that are followed to wrong places.
TEST(LidarSearches, ScansThatHardlyShareASurfaceAreNotTracked) {
  const testing::Scene room = testing::room(1, {8.0, 6.0, 2.8});
  LidarOptions options = one_thread();
  options.search = false;
  LidarOdometry odometry(options);
  for (unsigned k = 0; k < 11; ++k) {
    const double t = k + 0.3;
    const Rigid3 place{rotation_exp({0.5 * std::sin(2.1 * t), 0.5 * std::cos(1.7 * t), 1.5 * std::sin(0.9 * t)}),
                       {0.5 * std::sin(1.3 * t), 0.5 * std::cos(1.1 * t), 1.2}};
    const synthetic::Sweep sweep =
        synthetic::scan({room, {}}, small_lidar(), synthetic::standing_at(place), k + 1, k * kSweep_s);
    const FrameReport report = odometry.add(k * kSweep_s, sweep.cloud);
    if (report.status == FrameStatus::Tracked) {
      EXPECT_GT(report.overlap, 0.25) << "scan " << k;
    }
  }
}

// A quarter of a turn between two scans, in the middle of a bare room: a search finds it turned to the left and to the
// right, and both fit.
TEST(LidarSearches, FarPosesOfWhichAnotherFitsAsWellAreNotBelieved) {
  testing::Scene room;
  const Rigid3 upright{Eigen::Quaterniond::Identity(), {0.0, 0.0, 1.4}};
  add_box(room, upright, {6.0, 4.0, 2.8});
  LidarOdometry odometry(one_thread());
  const auto added = [&](double yaw, unsigned k) {
    const Rigid3 place = upright * Rigid3{rotation_exp({0.0, 0.0, yaw}), Vec3d::Zero()};
    return odometry.add(k * kSweep_s, synthetic::scan(room, small_lidar(), place, k + 1)).status;
  };
  for (unsigned k = 0; k < 3; ++k) added(0.0, k);
  EXPECT_THAT(added(0.5 * std::numbers::pi, 3), ::testing::AnyOf(FrameStatus::Lost, FrameStatus::Doubtful));
}

// The sensor is moved by hand while other scans arrive: only a search finds it. Lost scans in a row are searched for at
// the first, second, fourth and eighth, so that a long loss costs four searches.
TEST(LidarSearches, OfLostScansInARowFewerAndFewerAreSearchedFor) {
  const testing::Scene street = synthetic::street(5), elsewhere = synthetic::open_field();
  const Rigid3 moved = street.world_from_camera * Rigid3{rotation_exp({0.0, 0.0, 1.2}), {0.5, 0.3, 0.0}};
  LidarOdometry odometry(one_thread());
  int k = 0;
  const auto added = [&](const testing::Scene& scene, const Rigid3& place) {
    const Cloud scan = synthetic::scan(scene, small_lidar(), place, static_cast<unsigned>(k + 1));
    return odometry.add(kSweep_s * k++, scan).status;
  };
  for (int i = 0; i < 3; ++i) added(street, street.world_from_camera);
  const auto is_astray = ::testing::AnyOf(FrameStatus::Lost, FrameStatus::Doubtful);
  for (int i = 0; i < 2; ++i) ASSERT_THAT(added(elsewhere, elsewhere.world_from_camera), is_astray);
  EXPECT_THAT(added(street, moved), is_astray);
  EXPECT_EQ(added(street, moved), FrameStatus::Tracked);
}

}  // namespace
}  // namespace augicp
