// SPDX-License-Identifier: MIT
#include "augicp/synthetic/lidar.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <set>
#include <stdexcept>

#include "augicp/core/angles.h"
#include "augicp/geometry/rotation.h"
#include "augicp/synthetic/outdoor_scenes.h"

namespace augicp::synthetic {
namespace {

Lidar small_lidar() {
  Lidar lidar;
  lidar.num_rings = 16;
  lidar.num_azimuths = 90;
  lidar.range_sigma = 0.0;
  return lidar;
}

double elevation_of(const Vec3f& point) { return std::atan2(point.z(), point.head<2>().norm()); }

TEST(Lidar, RingsHaveTheirElevations) {
  const Lidar lidar = small_lidar();
  const Sweep sweep = scan({tunnel(), {}}, lidar, standing_at(tunnel().world_from_camera), 1);
  ASSERT_GT(sweep.cloud.size(), 1000u);
  for (std::size_t i = 0; i < sweep.cloud.size(); ++i) {
    const double share = sweep.rings[i] / (lidar.num_rings - 1.0);
    const double expected_deg = lidar.min_elevation_deg + share * (lidar.max_elevation_deg - lidar.min_elevation_deg);
    EXPECT_NEAR(elevation_of(sweep.cloud.points[i]), expected_deg * kRadPerDeg, 1e-5);
  }
}

TEST(Lidar, PointsLieOnTheSurfaceThatIsNamed) {
  const testing::Scene scene = corridor(2.5, 2.8);
  const Sweep sweep = scan({scene, {}}, small_lidar(), standing_at(scene.world_from_camera), 1);
  std::set<int> seen;
  for (std::size_t i = 0; i < sweep.cloud.size(); ++i) {
    const Vec3d place = scene.world_from_camera * sweep.cloud.points[i].cast<double>();
    const double off[] = {place.z(), place.z() - 2.8, place.y() + 1.25, place.y() - 1.25};
    ASSERT_GE(sweep.surfaces[i], 0);
    EXPECT_NEAR(off[sweep.surfaces[i]], 0.0, 1e-4);
    seen.insert(sweep.surfaces[i]);
  }
  EXPECT_EQ(seen.size(), 4u);
}

TEST(Lidar, RangeLimitsDropWhatIsNearerAndFarther) {
  Lidar lidar = small_lidar();
  lidar.min_range = 4.0;
  lidar.max_range = 20.0;
  const Cloud cloud = scan(open_field(), lidar, open_field().world_from_camera, 1);
  ASSERT_FALSE(cloud.empty());
  for (const Vec3f& point : cloud.points) {
    EXPECT_GE(point.norm(), 4.0f - 1e-4f);
    EXPECT_LE(point.norm(), 20.0f + 1e-4f);
  }
}

// The noise is along the ray, and its spread is what was asked for.
TEST(Lidar, NoiseIsOfTheRange) {
  Lidar exact = small_lidar(), noisy = exact;
  exact.num_azimuths = noisy.num_azimuths = 720;
  noisy.range_sigma = 0.02;
  const Cloud clean = scan(corridor(), exact, corridor().world_from_camera, 3);
  const Cloud spoilt = scan(corridor(), noisy, corridor().world_from_camera, 3);
  ASSERT_EQ(clean.size(), spoilt.size());
  double sum_sq = 0.0;
  for (std::size_t i = 0; i < clean.size(); ++i) {
    const Vec3d p = clean.points[i].cast<double>(), q = spoilt.points[i].cast<double>();
    EXPECT_NEAR(p.cross(q).norm() / p.squaredNorm(), 0.0, 1e-6);
    sum_sq += (p - q).squaredNorm();
  }
  EXPECT_NEAR(std::sqrt(sum_sq / static_cast<double>(clean.size())), 0.02, 0.001);
}

// While the sensor moves, its points straightened by the true motion lie on the scene, seen from where it then was.
TEST(Lidar, AMovingSweepStraightenedLiesOnTheScene) {
  const testing::Scene scene = corridor(2.5, 2.8);
  const Motion motion = moving_evenly(scene.world_from_camera, {rotation_exp({0.0, 0.0, 1.5}), {4.0, 0.5, 0.0}});
  const Sweep sweep = scan({scene, {}}, small_lidar(), motion, 1, 2.0);
  const Cloud at_end = straightened(sweep, motion, 2.0, 0.1);
  double raw_off = 0.0;
  for (std::size_t i = 0; i < at_end.size(); ++i) {
    const auto height_off = [&](const Vec3f& point, int surface) {
      const Vec3d place = motion(2.1) * point.cast<double>();
      const double off[] = {place.z(), place.z() - 2.8, place.y() + 1.25, place.y() - 1.25};
      return std::abs(off[surface]);
    };
    EXPECT_NEAR(height_off(at_end.points[i], sweep.surfaces[i]), 0.0, 1e-4);
    raw_off = std::max(raw_off, height_off(sweep.cloud.points[i], sweep.surfaces[i]));
  }
  EXPECT_GT(raw_off, 0.1);
}

TEST(Lidar, TimesGrowWithTheAzimuth) {
  const Lidar lidar = small_lidar();
  const Sweep sweep = scan({tunnel(), {}}, lidar, standing_at(tunnel().world_from_camera), 1);
  for (std::size_t i = 0; i < sweep.cloud.size(); ++i) {
    const Vec3f& point = sweep.cloud.points[i];
    double turn = std::atan2(point.y(), point.x()) / (2.0 * std::numbers::pi);
    if (turn < -1e-6) turn += 1.0;
    EXPECT_NEAR(sweep.times_s[i], lidar.sweep_s * turn, 1e-6);
  }
}

// A sphere that crosses is seen where it is at the time of each ray.
TEST(Lidar, AMovingObjectIsSeenWhereItIsThen) {
  MovingObject ball;
  add_surface(ball.scene, testing::Sphere{Vec3d::Zero(), 1.0});
  ball.world_from_object = moving_evenly({Eigen::Quaterniond::Identity(), {-6.0, 0.0, 1.6}},
                                         {Eigen::Quaterniond::Identity(), {0.0, 20.0, 0.0}});
  const World world{open_field(), {ball}};
  const Sweep sweep = scan(world, small_lidar(), standing_at(world.scene.world_from_camera), 1);
  int num_on_ball = 0;
  for (std::size_t i = 0; i < sweep.cloud.size(); ++i) {
    if (sweep.surfaces[i] != Sweep::kMoving) continue;
    const Vec3d centre = ball.world_from_object(sweep.times_s[i]).translation;
    const Vec3d place = world.scene.world_from_camera * sweep.cloud.points[i].cast<double>();
    EXPECT_NEAR((place - centre).norm(), 1.0, 1e-4);
    ++num_on_ball;
  }
  EXPECT_GT(num_on_ball, 20);
}

TEST(Lidar, TheSameSeedGivesTheSamePoints) {
  Lidar lidar = small_lidar();
  lidar.range_sigma = 0.01;
  const testing::Scene scene = street(4);
  EXPECT_EQ(scan(scene, lidar, scene.world_from_camera, 7).points,
            scan(scene, lidar, scene.world_from_camera, 7).points);
  EXPECT_NE(scan(scene, lidar, scene.world_from_camera, 7).points,
            scan(scene, lidar, scene.world_from_camera, 8).points);
}

TEST(Lidar, NumbersOutOfRangeAreRefused) {
  for (void (*spoil)(Lidar&) : {+[](Lidar& l) { l.num_rings = 0; }, +[](Lidar& l) { l.num_azimuths = 0; },
                                +[](Lidar& l) { l.max_range = l.min_range; }, +[](Lidar& l) { l.range_sigma = -1.0; },
                                +[](Lidar& l) { l.min_elevation_deg = 90.0; }}) {
    Lidar lidar = small_lidar();
    spoil(lidar);
    EXPECT_THROW(scan(open_field(), lidar, Rigid3{}, 1), std::invalid_argument);
  }
}

// Shifted by the period, a colonnade is seen as before; by half of it, it is not.
TEST(OutdoorScenes, AColonnadeRepeats) {
  const testing::Scene scene = colonnade(3.0);
  Lidar lidar = small_lidar();
  lidar.max_range = 40.0;
  const auto from = [&](double x) {
    const Rigid3 shift{Eigen::Quaterniond::Identity(), {x, 0.0, 0.0}};
    return scan(scene, lidar, shift * scene.world_from_camera, 1);
  };
  const Cloud here = from(0.0), next = from(3.0), between = from(1.5);
  ASSERT_EQ(here.size(), next.size());
  for (std::size_t i = 0; i < here.size(); ++i) EXPECT_LT((here.points[i] - next.points[i]).norm(), 1e-3f);
  EXPECT_NE(here.size(), between.size());
}

}  // namespace
}  // namespace augicp::synthetic
