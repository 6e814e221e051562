// SPDX-License-Identifier: MIT
#include "augicp/odometry/shown_motion.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <vector>

namespace augicp {
namespace {

// A room that a spinning sensor scans in order of azimuth: walls, floor and ceiling, each point with its plane.
struct Scanned {
  Cloud points;  // where they are, with normals, in the frame of the sensor in the middle of the sweep
  SweepShares shares;
  std::vector<Correspondence> pairs;  // each point with itself
};

Scanned scanned_room(double noise) {
  std::mt19937 generator(5);
  std::uniform_real_distribution<double> height(-1.0, 1.0);
  std::normal_distribution<double> error(0.0, noise);
  Scanned scanned;
  constexpr std::uint32_t kNumPoints = 4000;
  for (std::uint32_t i = 0; i < kNumPoints; ++i) {
    const double share = (i + 0.5) / kNumPoints, azimuth = 2.0 * std::numbers::pi * share;
    const Vec3d ray(std::cos(azimuth), std::sin(azimuth), height(generator));
    const Vec3d along(std::abs(ray.x()) / 4.0, std::abs(ray.y()) / 3.0, std::abs(ray.z()) / 1.3);
    Eigen::Index axis = 0;
    const double nearest = along.maxCoeff(&axis);
    const Vec3d normal = Vec3d::Unit(axis);
    scanned.points.points.push_back((ray / nearest + error(generator) * normal).cast<float>());
    scanned.points.directions.push_back(normal.cast<float>());
    scanned.points.structures.push_back(Structure::Planar);
    scanned.shares.push_back(static_cast<float>(share));
    scanned.pairs.push_back({i, i});
  }
  return scanned;
}

// A pose, and a motion that constant velocity does not know.
const Rigid3 kWorldFromSensor{Eigen::Quaterniond(0.9, 0.1, -0.2, 0.4).normalized(), {5.0, -3.0, 1.0}};

SweepMotion jerk() {
  SweepMotion motion;
  motion.velocity = {0.08, -0.05, 0.02};
  motion.rotation = {0.01, -0.015, 0.04};
  motion.acceleration = {0.1, 0.05, -0.05};
  motion.angular_acceleration = {-0.02, 0.03, 0.1};
  return motion;
}

// What is found of jerk(), from points straightened as if the sensor had stood.
std::optional<SweepMotion> found(const Scanned& scanned, double sigma) {
  Cloud as_measured = scanned.points;
  const SweepMotion motion = jerk();
  for (std::size_t i = 0; i < as_measured.size(); ++i) {
    const Rigid3 sensor_from_middle = inverse(motion.middle_from(static_cast<double>(scanned.shares[i])));
    as_measured.points[i] = (sensor_from_middle * as_measured.points[i].cast<double>()).cast<float>();
  }
  const Cloud target = transform(scanned.points, kWorldFromSensor);
  const PosedPairs posed{as_measured, target, scanned.pairs, without_origins(kWorldFromSensor, as_measured, target)};
  return shown_motion(posed, scanned.shares, {SweepMotion{}, sigma, 3.0, 0.4});
}

double bend_between(const SweepMotion& a, const SweepMotion& b) {
  double largest = 0.0;
  for (const double share : {0.0, 0.25, 0.75, 1.0}) {
    const Rigid3 apart = inverse(a.middle_from(share)) * b.middle_from(share);
    largest = std::max(largest, apart.translation.norm() + 3.0 * angle_between(apart, Rigid3{}));
  }
  return largest;
}

// One step leaves what is of second order: a twentieth.
TEST(ShownMotion, IsThatWithWhichTheSweepWasMeasured) {
  const double before = bend_between(SweepMotion{}, jerk());
  const std::optional<SweepMotion> exact = found(scanned_room(0.0), 1.0), noisy = found(scanned_room(0.01), 1.0);
  ASSERT_TRUE(exact && noisy);
  EXPECT_LT(bend_between(*exact, jerk()), 0.05 * before);
  EXPECT_LT(bend_between(*noisy, jerk()), 0.1 * before);
}

TEST(ShownMotion, StaysAtAPriorThatIsCertain) {
  const std::optional<SweepMotion> motion = found(scanned_room(0.01), 1e-6);
  ASSERT_TRUE(motion);
  EXPECT_LT(bend_between(*motion, SweepMotion{}), 1e-3 * bend_between(SweepMotion{}, jerk()));
}

TEST(ShownMotion, IsUnknownFromFewPairs) {
  Scanned scanned = scanned_room(0.01);
  scanned.pairs.resize(49);
  EXPECT_FALSE(found(scanned, 1.0));
}

// Edges say nothing here: their points are not on planes.
TEST(ShownMotion, IsAskedOfPlanesAlone) {
  Scanned scanned = scanned_room(0.01);
  for (Structure& structure : scanned.points.structures) structure = Structure::Edge;
  EXPECT_FALSE(found(scanned, 1.0));
}

}  // namespace
}  // namespace augicp
