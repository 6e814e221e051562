// SPDX-License-Identifier: MIT
#include "augicp/registration/start/repeated_rotations.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "augicp/core/angles.h"
#include "augicp/geometry/rotation.h"

namespace augicp {
namespace {

// A round plate about the vertical through a place, with a peg at each of these angles, degrees.
Cloud plate_with_pegs(const std::vector<double>& angles_deg, const Vec3d& place, int points_per_peg = 200) {
  std::mt19937 generator(1);
  std::uniform_real_distribution<double> part(0.0, 1.0);
  Cloud cloud;
  const auto add = [&](double distance, double angle, double height) {
    const Vec3d point(distance * std::cos(angle), distance * std::sin(angle), height);
    cloud.points.push_back((place + point).cast<float>());
  };
  for (int k = 0; k < 4000; ++k) add(std::sqrt(part(generator)), 2.0 * std::numbers::pi * part(generator), 0.0);
  for (const double angle_deg : angles_deg)
    for (int k = 0; k < points_per_peg; ++k)
      add(0.6 + 0.1 * part(generator), kRadPerDeg * angle_deg + 0.15 * part(generator), 0.3 * part(generator));
  return cloud;
}

std::vector<double> pegs(int count) {
  std::vector<double> angles_deg(static_cast<std::size_t>(count));
  for (int k = 0; k < count; ++k) angles_deg[static_cast<std::size_t>(k)] = 360.0 * k / count;
  return angles_deg;
}

TEST(RepeatedRotations, AreThoseOfThePegs) {
  const Vec3d place(1.0, -2.0, 3.0);
  for (const int count : {3, 5, 8}) {
    const auto turns = repeated_rotations(plate_with_pegs(pegs(count), place), {place, Vec3d::UnitZ()});
    EXPECT_EQ(turns.size(), static_cast<std::size_t>(count / 2)) << count;
    for (const RepeatedRotation& turn : turns) {
      const double steps = turn.angle * count / (2.0 * std::numbers::pi);
      EXPECT_NEAR(steps, std::round(steps), 0.05) << count;
      EXPECT_GT(steps, 0.5) << count;
      EXPECT_GT(turn.resemblance, 0.4) << count;
      EXPECT_LE(turn.resemblance, 1.0) << count;
    }
  }
}

TEST(RepeatedRotations, DoNotDependOnTheFrame) {
  const Rigid3 turned{rotation_exp({0.7, -1.1, 0.4}), Vec3d::Zero()};
  const Vec3d place(10.0, 20.0, -5.0);
  const Cloud cloud = transform(plate_with_pegs(pegs(5), place), turned);
  const auto turns = repeated_rotations(cloud, {turned * place, turned.rotation * Vec3d::UnitZ()});
  ASSERT_EQ(turns.size(), 2u);
  for (const RepeatedRotation& turn : turns) EXPECT_NEAR(std::remainder(turn.angle, 0.4 * std::numbers::pi), 0.0, 0.05);
}

// The plate is then not at one height, and its points vary about the axis more than the pegs.
TEST(RepeatedRotations, TheAxisMayBeTiltedByADegree) {
  const Cloud cloud = plate_with_pegs(pegs(5), Vec3d::Zero(), 100);
  for (const Vec3d& tilt_deg : {Vec3d(1.0, 0.0, 0.0), Vec3d(0.0, 1.0, 0.0)}) {
    const auto rotations =
        repeated_rotations(cloud, {Vec3d::Zero(), rotation_exp(kRadPerDeg * tilt_deg) * Vec3d::UnitZ()});
    ASSERT_FALSE(rotations.empty());
    EXPECT_NEAR(std::remainder(rotations.front().angle, 0.4 * std::numbers::pi), 0.0, 0.06);
  }
}

// Five pegs above and five below, halfway between them: seen from above they look like ten. A far outlier must not put
// all of them at one height.
TEST(RepeatedRotations, HeightsAreToldApartBesideAnOutlier) {
  Cloud cloud = plate_with_pegs(pegs(5), Vec3d::Zero());
  for (Vec3f point : plate_with_pegs({36.0, 108.0, 180.0, 252.0, 324.0}, Vec3d::Zero()).points)
    cloud.points.emplace_back(point.x(), point.y(), -point.z());
  cloud.points.emplace_back(300.0f, 0.0f, 50.0f);
  const auto rotations = repeated_rotations(cloud, {Vec3d::Zero(), Vec3d::UnitZ()});
  ASSERT_EQ(rotations.size(), 2u);
  for (const RepeatedRotation& by : rotations) EXPECT_NEAR(std::remainder(by.angle, 0.4 * std::numbers::pi), 0.0, 0.06);
}

TEST(RepeatedRotations, OnePegMayBeMissing) {
  const auto turns =
      repeated_rotations(plate_with_pegs({72.0, 144.0, 216.0, 288.0}, Vec3d::Zero()), {Vec3d::Zero(), Vec3d::UnitZ()});
  ASSERT_FALSE(turns.empty());
  EXPECT_NEAR(std::remainder(turns.front().angle, 0.4 * std::numbers::pi), 0.0, 0.05);
}

TEST(RepeatedRotations, ThereAreNoneOfAPlateOrOfUnevenPegs) {
  for (const std::vector<double>& angles_deg :
       {std::vector<double>{}, std::vector<double>{0.0}, std::vector<double>{0.0, 50.0, 110.0, 200.0, 265.0}})
    EXPECT_TRUE(repeated_rotations(plate_with_pegs(angles_deg, Vec3d::Zero()), {Vec3d::Zero(), Vec3d::UnitZ()}).empty())
        << angles_deg.size();
  EXPECT_TRUE(repeated_rotations({}, {Vec3d::Zero(), Vec3d::UnitZ()}).empty());
}

}  // namespace
}  // namespace augicp
