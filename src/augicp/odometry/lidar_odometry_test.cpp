// SPDX-License-Identifier: MIT
#include "augicp/odometry/lidar_odometry.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <stdexcept>
#include <utility>

#include "augicp/core/error.h"
#include "augicp/geometry/rotation.h"
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

const testing::Scene& street() {
  static const testing::Scene scene = synthetic::street(5);
  return scene;
}

// 5 m/s and 20 degrees a second.
synthetic::Motion driving() {
  return synthetic::moving_evenly(street().world_from_camera, {rotation_exp({0.0, 0.0, 0.35}), {5.0, 0.0, 0.0}});
}

struct Timed {
  double stamp_s;
  Cloud cloud;
  SweepShares shares;
};

std::vector<Timed> sweeps(const testing::Scene& scene, const synthetic::Motion& motion, int count) {
  std::vector<Timed> all;
  for (int k = 0; k < count; ++k) {
    const synthetic::Sweep sweep =
        synthetic::scan({scene, {}}, small_lidar(), motion, static_cast<unsigned>(k + 1), k * kSweep_s);
    all.push_back({k * kSweep_s, sweep.cloud, shares_from_times(sweep.times_s)});
  }
  return all;
}

const std::vector<Timed>& drive() {
  static const std::vector<Timed> all = sweeps(street(), driving(), 8);
  return all;
}

// The sensor at the middle of sweep k, in the frame of the middle of the first.
Rigid3 true_pose(int k) { return inverse(driving()(0.5 * kSweep_s)) * driving()((k + 0.5) * kSweep_s); }

TEST(LidarOdometry, FollowsASensorThatMovesDuringItsSweeps) {
  LidarOdometry odometry(one_thread());
  for (int k = 0; k < 8; ++k) {
    const Timed& scan = drive()[static_cast<std::size_t>(k)];
    const FrameReport report = odometry.add(scan.stamp_s, scan.cloud, scan.shares);
    EXPECT_EQ(report.status, k == 0 ? FrameStatus::Started : FrameStatus::Tracked);
    EXPECT_THAT(report.world_from_camera, NearPose(true_pose(k), 0.003, 0.03)) << "sweep " << k;
  }
}

TEST(LidarOdometry, PosesReferToTheMomentThatIsChosen) {
  for (const auto& [instant, share] : {std::pair{PoseInstant::Begin, 0.0}, std::pair{PoseInstant::End, 1.0}}) {
    LidarOptions options = one_thread();
    options.pose_at = instant;
    LidarOdometry odometry(options);
    for (int k = 0; k < 4; ++k) {
      const Timed& scan = drive()[static_cast<std::size_t>(k)];
      const Rigid3 found = odometry.add(scan.stamp_s, scan.cloud, scan.shares).world_from_camera;
      const Rigid3 true_one = inverse(driving()(0.5 * kSweep_s)) * driving()((k + share) * kSweep_s);
      EXPECT_THAT(found, NearPose(k == 0 ? Rigid3{} : true_one, 0.003, 0.03)) << "sweep " << k;
    }
  }
}

TEST(LidarOdometry, StandstillDoesNotDrift) {
  const std::vector<Timed> all = sweeps(street(), synthetic::standing_at(street().world_from_camera), 4);
  LidarOdometry odometry(one_thread());
  for (const Timed& scan : all) {
    const FrameReport report = odometry.add(scan.stamp_s, scan.cloud, scan.shares);
    EXPECT_THAT(report.world_from_camera, NearPose(Rigid3{}, 0.0005, 0.003));
  }
}

TEST(LidarOdometry, GivesTheSameBitsOnAnyNumberOfThreads) {
  std::vector<FrameReport> first;
  Cloud first_map;
  for (const int num_threads : testing::cases({1, 3, 8, 2, 4, 5, 6, 7}, 3)) {
    LidarOptions options;
    options.num_threads = num_threads;
    options.covariance = true;
    options.check_every = 2;
    LidarOdometry odometry(options);
    for (std::size_t k = 0; k < 4; ++k) {
      const FrameReport report = odometry.add(drive()[k].stamp_s, drive()[k].cloud, drive()[k].shares);
      if (num_threads == 1) first.push_back(report);
      EXPECT_EQ(report.world_from_camera.matrix(), first[k].world_from_camera.matrix());
      EXPECT_EQ(report.covariance, first[k].covariance);
      ASSERT_EQ(report.drift.has_value(), first[k].drift.has_value());
      EXPECT_EQ(report.drift ? report.drift->drift_m : 0.0, first[k].drift ? first[k].drift->drift_m : 0.0);
    }
    EXPECT_TRUE(first[2].drift);
    if (num_threads == 1) first_map = odometry.map();
    EXPECT_EQ(odometry.map().points, first_map.points);
    EXPECT_EQ(odometry.map().directions, first_map.directions);
  }
}

TEST(LidarOdometry, NamesTheAxisOfACorridor) {
  const testing::Scene scene = synthetic::corridor();
  const std::vector<Timed> all = sweeps(scene, synthetic::standing_at(scene.world_from_camera), 2);
  LidarOdometry odometry(one_thread());
  odometry.add(all[0].stamp_s, all[0].cloud);
  const FrameReport report = odometry.add(all[1].stamp_s, all[1].cloud);
  EXPECT_EQ(report.status, FrameStatus::Degenerate);
  ASSERT_EQ(report.free_motions.size(), 1u);
  EXPECT_GT(std::abs(report.free_motions[0].axis.x()), 0.99);
}

// Sixteen or thirty-two rings, as sparse as those of a VLP-16 or an HDL-32E.
synthetic::Lidar sparse_lidar(int num_rings) {
  synthetic::Lidar lidar;
  lidar.num_rings = num_rings;
  lidar.num_azimuths = 900;
  lidar.min_elevation_deg = num_rings == 16 ? -15.0 : -30.67;
  lidar.max_elevation_deg = num_rings == 16 ? 15.0 : 10.67;
  lidar.range_sigma = 0.015;
  lidar.min_range = 0.3;
  lidar.sweep_s = kSweep_s;
  return lidar;
}

// The reports on the second and third sweep of a sensor that walks along x.
std::vector<FrameReport> reports_in(const testing::Scene& scene, const Rigid3& place, const synthetic::Lidar& lidar) {
  const synthetic::Motion walking = synthetic::moving_evenly(place, {Eigen::Quaterniond::Identity(), {0.6, 0.0, 0.0}});
  LidarOdometry odometry(one_thread());
  std::vector<FrameReport> reports;
  for (unsigned k = 0; k < 3; ++k) {
    const synthetic::Sweep sweep = synthetic::scan({scene, {}}, lidar, walking, k + 1, k * kSweep_s);
    reports.push_back(odometry.add(k * kSweep_s, sweep.cloud, shares_from_times(sweep.times_s)));
  }
  reports.erase(reports.begin());
  return reports;
}

TEST(LidarOdometry, SparseRingsTrackARoomWhoseFloorTheySee) {
  const testing::Scene hall = testing::room(1, {14.0, 11.0, 3.5});
  const Rigid3 place{Eigen::Quaterniond::Identity(), {-2.8, 0.1, 1.0}};
  for (const FrameReport& report : reports_in(hall, place, sparse_lidar(16)))
    EXPECT_EQ(report.status, FrameStatus::Tracked);
}

// Rings and columns of rays that cross a corner are no walls across the corridor, and nothing pulls along it.
TEST(LidarOdometry, SparseRingsLeaveACorridorFree) {
  for (const int num_rings : {16, 32})
    for (const double width : testing::cases({3.4, 2.6, 4.2}, 1)) {
      const testing::Scene corridor = synthetic::corridor(width, 2.6);
      for (const FrameReport& report : reports_in(corridor, corridor.world_from_camera, sparse_lidar(num_rings))) {
        EXPECT_EQ(report.status, FrameStatus::Degenerate) << num_rings << " rings, " << width << " m wide";
        EXPECT_LT(std::abs(report.world_from_camera.translation.x()), 0.02);  // the prediction: at rest
      }
    }
}

TEST(LidarOdometry, ALostScanDoesNotEndTheRun) {
  const Cloud elsewhere =
      synthetic::scan(synthetic::colonnade(), small_lidar(), synthetic::colonnade().world_from_camera, 1);
  LidarOptions options = one_thread();
  options.search = false;
  LidarOdometry odometry(options);
  for (std::size_t k = 0; k < 4; ++k) odometry.add(drive()[k].stamp_s, drive()[k].cloud, drive()[k].shares);
  const FrameReport lost = odometry.add(drive()[4].stamp_s, elsewhere);
  EXPECT_THAT(lost.status, ::testing::AnyOf(FrameStatus::Lost, FrameStatus::Doubtful));
  const FrameReport found = odometry.add(drive()[5].stamp_s, drive()[5].cloud, drive()[5].shares);
  EXPECT_EQ(found.status, FrameStatus::Tracked);
  EXPECT_THAT(found.world_from_camera, NearPose(true_pose(5), 0.003, 0.03));
}

TEST(LidarOdometry, TellsWhatIsWrongWithAScan) {
  LidarOdometry odometry(one_thread());
  EXPECT_EQ(odometry.add(0.0, Cloud{}).status, FrameStatus::NoReadings);
  EXPECT_EQ(odometry.add(1.0, drive()[0].cloud).status, FrameStatus::Started);
  const FrameReport early = odometry.add(0.5, drive()[1].cloud), again = odometry.add(1.0, drive()[1].cloud);
  EXPECT_EQ(early.status, FrameStatus::OutOfOrder);
  EXPECT_EQ(early.problem, "its stamp, 0.500000 s, is not after 1.000000 s, that of a frame before it");
  EXPECT_EQ(again.status, FrameStatus::OutOfOrder);
  EXPECT_EQ(odometry.add(std::numeric_limits<double>::quiet_NaN(), drive()[1].cloud).status, FrameStatus::OutOfOrder);
  EXPECT_THROW(odometry.add(2.0, drive()[1].cloud, {0.0f, 1.0f}), std::invalid_argument);
}

TEST(LidarOdometry, AStopLeavesEverythingAsItWas) {
  std::stop_source stop;
  LidarOptions options = one_thread();
  options.stop = stop.get_token();
  LidarOdometry odometry(options), undisturbed(one_thread());
  odometry.add(drive()[0].stamp_s, drive()[0].cloud);
  undisturbed.add(drive()[0].stamp_s, drive()[0].cloud);
  stop.request_stop();
  EXPECT_THROW(odometry.add(drive()[1].stamp_s, drive()[1].cloud), Interrupted);
  EXPECT_EQ(odometry.map().points, undisturbed.map().points);
}

std::size_t num_edges(const Cloud& cloud) {
  return static_cast<std::size_t>(std::count(cloud.structures.begin(), cloud.structures.end(), Structure::Edge));
}

TEST(LidarOdometry, PartsCanBeLeftOut) {
  LidarOptions all = one_thread(), no_edges = one_thread(), last_scan = one_thread();
  no_edges.parts.has_edges = false;
  last_scan.parts.is_last_scan_alone = true;
  LidarOdometry with_all(all), without_edges(no_edges), to_last(last_scan);
  for (const Timed& scan : drive())
    for (LidarOdometry* odometry : {&with_all, &without_edges, &to_last})
      odometry->add(scan.stamp_s, scan.cloud, scan.shares);
  EXPECT_GT(num_edges(with_all.map()), 0u);
  EXPECT_EQ(num_edges(without_edges.map()), 0u);
  LidarOdometry last_alone(all);
  last_alone.add(drive().back().stamp_s, drive().back().cloud);
  EXPECT_NEAR(static_cast<double>(to_last.num_voxels()), static_cast<double>(last_alone.num_voxels()),
              0.15 * static_cast<double>(last_alone.num_voxels()));
  EXPECT_GT(with_all.num_voxels(), to_last.num_voxels() + to_last.num_voxels() / 4);
}

TEST(LidarOdometry, OptionsOutOfRangeAreRefused) {
  LidarOptions options;
  options.voxel_size = 0.0;
  EXPECT_THROW(LidarOdometry{options}, std::invalid_argument);
  options = {};
  options.keyframe_distance_voxels = -1.0;
  EXPECT_THROW(LidarOdometry{options}, std::invalid_argument);
}

}  // namespace
}  // namespace augicp
