// SPDX-License-Identifier: MIT
#include "augicp/trust/motion_probe.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "augicp/cloud/voxel_grid.h"
#include "augicp/surface/ball_neighbourhood.h"
#include "augicp/surface/estimate_surface.h"
#include "augicp/synthetic/lidar.h"
#include "augicp/synthetic/outdoor_scenes.h"
#include "augicp/testing/degenerate_families.h"
#include "augicp/testing/random_clouds.h"

namespace augicp {
namespace {

constexpr double kRadius_m = 0.06;
const AgreementTolerance kProbeTolerance{.distance = 0.5 * kRadius_m};

Cloud with_surface(Cloud cloud, double radius) {
  const BallNeighbourhood balls(cloud, {radius, 10, 3.0 * radius}, 1);
  estimate_surface(cloud, balls, {}, 1);
  return cloud;
}

Cloud drawn(const testing::DegenerateFamily& family, std::mt19937& generator) {
  return with_surface(testing::draw(family, 12000, family.noise, generator), kRadius_m);
}

Vec6d translation(const Vec3d& along) { return (Vec6d() << along, Vec3d::Zero()).finished(); }

// Two draws of one shape, so that no point has a partner of its own.
TEST(MotionProbe, SaysNothingOfMotionsThatLeaveAShapeAsItIs) {
  std::mt19937 generator(1);
  for (const testing::DegenerateFamily& family : testing::degenerate_families()) {
    if (family.name == "wire") continue;  // a line has no surroundings
    const Cloud source = drawn(family, generator), target = drawn(family, generator);
    const auto spoken = MotionProbe(source, target, kProbeTolerance, kRadius_m).spoken_of({}, family.free_motions);
    EXPECT_EQ(spoken, std::vector<bool>(family.free_motions.size(), false)) << family.name;
  }
}

TEST(MotionProbe, SpeaksOfMotionsAcrossASurface) {
  std::mt19937 generator(1);
  const auto families = testing::degenerate_families();
  const Cloud source = drawn(families[0], generator), target = drawn(families[0], generator);
  Vec3d normal = Vec3d::Zero();
  for (std::size_t i = 0; i < target.size(); ++i)
    if (target.structures[i] == Structure::Planar) normal = target.directions[i].cast<double>();
  const std::vector<Vec6d> across{translation(normal), translation(-1e-3 * normal), translation(40.0 * normal)};
  EXPECT_EQ(MotionProbe(source, target, kProbeTolerance, kRadius_m).spoken_of({}, across), std::vector<bool>(3, true));
}

TEST(MotionProbe, ComparesPosesByThePointsOnTheSurface) {
  std::mt19937 generator(1);
  const testing::DegenerateFamily plane = testing::degenerate_families()[0];
  const Cloud source = drawn(plane, generator), target = drawn(plane, generator);
  const MotionProbe probe(source, target, kProbeTolerance, kRadius_m);
  const Vec6d along = plane.free_motions[0].normalized();
  Vec3d normal = Vec3d::Zero();
  for (std::size_t i = 0; i < target.size(); ++i)
    if (target.structures[i] == Structure::Planar) normal = target.directions[i].cast<double>();
  const Rigid3 off = retract({}, translation(kRadius_m * normal)), beside = retract({}, 0.5 * kRadius_m * along);
  EXPECT_EQ(probe.compared({}, off), 1);
  EXPECT_EQ(probe.compared(off, {}), -1);
  EXPECT_EQ(probe.compared(beside, {}), 0);
}

// A step back towards the right pose loses nothing.
TEST(MotionProbe, APoseThatHasSlidIsNotHeld) {
  std::mt19937 generator(1);
  const testing::DegenerateFamily plane = testing::degenerate_families()[0];
  const Cloud source = drawn(plane, generator), target = drawn(plane, generator);
  const MotionProbe probe(source, target, kProbeTolerance, kRadius_m);
  Vec3d normal = Vec3d::Zero();
  for (std::size_t i = 0; i < target.size(); ++i)
    if (target.structures[i] == Structure::Planar) normal = target.directions[i].cast<double>();
  const std::vector<Vec6d> across{translation(normal), translation(-3.0 * normal)};
  EXPECT_EQ(probe.held_along({}, across), std::vector<bool>(2, true));
  const Rigid3 slid = retract({}, translation(kRadius_m * normal));
  EXPECT_EQ(probe.held_along(slid, across), std::vector<bool>(2, false));
  EXPECT_EQ(probe.spoken_of(slid, across), std::vector<bool>(2, true));
  const Vec6d along = plane.free_motions[0].normalized();
  EXPECT_EQ(probe.held_along({}, std::vector{along}), std::vector<bool>(1, false));
}

// Scan lines on a bare wall move with the sensor: both scans agree best where it seems to stand still.
TEST(MotionProbe, ScanLinesSayNothingOfTheWayAlongACorridor) {
  const testing::Scene scene = synthetic::corridor();
  for (const int num_rings : {16, 64}) {
    synthetic::Lidar lidar;
    lidar.num_rings = num_rings;
    lidar.num_azimuths = 900;
    const Rigid3 ahead{Eigen::Quaterniond::Identity(), {0.8, 0.0, 0.0}};
    const double radius = 0.25;
    const auto seen_from = [&](const Rigid3& place, unsigned seed) {
      return with_surface(downsample(synthetic::scan(scene, lidar, place, seed), 0.25 * radius), radius);
    };
    const Cloud source = seen_from(scene.world_from_camera * ahead, 1), target = seen_from(scene.world_from_camera, 2);
    const MotionProbe probe(source, target, {.distance = 0.5 * radius}, radius);
    ASSERT_TRUE(probe.can_tell()) << num_rings;
    const std::vector<Vec6d> ways{translation(Vec3d::UnitX()), translation(Vec3d::UnitY())};
    EXPECT_EQ(probe.spoken_of({}, ways), (std::vector<bool>{false, true})) << num_rings;
  }
}

// Lines in one plane are a drawing, unless a sensor above the plane saw them: then they are scan lines.
TEST(MotionProbe, ScanLinesOfAFlatFieldAreNoDrawing) {
  Cloud rings;
  for (const double ring_m : {3.0, 6.0, 10.0})
    for (int k = 0; k < 600; ++k) {
      const double angle = 2.0 * std::numbers::pi * k / 600.0;
      rings.points.push_back(Vec3d(ring_m * std::cos(angle), ring_m * std::sin(angle), 0.0).cast<float>());
      rings.directions.push_back(Vec3d(-std::sin(angle), std::cos(angle), 0.0).cast<float>());
      rings.structures.push_back(Structure::Edge);
    }
  EXPECT_TRUE(MotionProbe(rings, rings, {.distance = 0.1}, 0.3).can_tell());
  const ProbedCloud from_above(rings, Vec3f(0.0f, 0.0f, 1.7f)), in_plane(rings, Vec3f(0.5f, 0.0f, 0.0f));
  EXPECT_FALSE(MotionProbe(from_above, from_above, {.distance = 0.1}, 0.3).can_tell());
  EXPECT_TRUE(MotionProbe(in_plane, in_plane, {.distance = 0.1}, 0.3).can_tell());
}

TEST(MotionProbe, CannotTellWherePointsAreFartherApartThanTheTolerance) {
  Cloud source = testing::random_extended_points(500, 5.0, 1), target = testing::random_extended_points(500, 5.0, 2);
  for (Cloud* cloud : {&source, &target})
    std::fill(cloud->structures.begin(), cloud->structures.end(), Structure::None);
  EXPECT_FALSE(MotionProbe(source, target, kProbeTolerance, kRadius_m).can_tell());
}

}  // namespace
}  // namespace augicp
