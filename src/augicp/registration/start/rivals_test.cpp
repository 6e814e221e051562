// SPDX-License-Identifier: MIT
#include "augicp/registration/start/rivals.h"

#include <gmock/gmock.h>

#include <numbers>
#include <random>

#include "augicp/geometry/rotation.h"
#include "augicp/registration/registration.h"
#include "augicp/testing/matchers.h"

namespace augicp {
namespace {

using testing::NearPose;

// The faces of a box of this size about the zero, evenly covered by random points.
void add_box(const Vec3d& size, const Vec3d& centre, std::size_t count, std::mt19937& generator, Cloud& cloud) {
  std::uniform_real_distribution<double> part(-0.5, 0.5);
  const Vec3d areas(size.y() * size.z(), size.x() * size.z(), size.x() * size.y());
  for (int axis = 0; axis < 3; ++axis)
    for (const double side : {-0.5, 0.5})
      for (std::size_t k = 0;
           k < static_cast<std::size_t>(0.5 * static_cast<double>(count) * areas[axis] / areas.sum()); ++k) {
        Vec3d point(part(generator), part(generator), part(generator));
        point[axis] = side;
        cloud.points.push_back((centre + point.cwiseProduct(size)).cast<float>());
      }
}

// A room of 6 x 4 x 3 m, bare or with a cupboard and a table.
Scan room(bool is_bare, unsigned seed) {
  std::mt19937 generator(seed);
  Cloud cloud;
  add_box({6.0, 4.0, 3.0}, Vec3d::Zero(), 20000, generator, cloud);
  if (!is_bare) {
    add_box({1.0, 0.6, 1.8}, {-2.3, -1.5, -0.6}, 4000, generator, cloud);
    add_box({1.2, 0.8, 0.7}, {1.5, 0.9, -1.1}, 4000, generator, cloud);
  }
  return scan_of(std::move(cloud));
}

const Rigid3 kTrueMotion{rotation_exp({0.03, -0.02, 0.05}), {0.05, -0.04, 0.03}};

AlignResult registered(bool is_bare) {
  Scan source = room(is_bare, 1);
  source.cloud = transform(source.cloud, inverse(kTrueMotion));
  return register_scans(std::move(source), room(is_bare, 2)).result;
}

// A cuboid is the same after half a turn about each of its axes.
TEST(Rivals, ABareRoomIsAmbiguous) {
  const AlignResult result = registered(true);
  EXPECT_THAT(result.target_from_source, NearPose(kTrueMotion, 0.01, 0.02));
  EXPECT_EQ(result.status, AlignStatus::Ambiguous);
  ASSERT_FALSE(result.runners_up.empty());
  for (const RunnerUp& other : result.runners_up) {
    EXPECT_NEAR(angle_between(other.target_from_source, kTrueMotion), std::numbers::pi, 0.02);
    EXPECT_LE(strain(other.evidence), 1.0);
  }
}

TEST(Rivals, FurnitureTellsWhichWayRound) {
  const AlignResult result = registered(false);
  EXPECT_THAT(result.target_from_source, NearPose(kTrueMotion, 0.01, 0.02));
  EXPECT_EQ(result.status, AlignStatus::Converged);
  EXPECT_TRUE(result.runners_up.empty());
}

// The same after half a turn about the vertical; on few points legs and plate are no thicker than the spacing.
Scan table(unsigned seed) {
  std::mt19937 generator(seed);
  Cloud cloud;
  add_box({1.2, 0.7, 0.03}, {0.0, 0.0, 0.7}, 8000, generator, cloud);
  for (const double x : {-0.55, 0.55})
    for (const double y : {-0.3, 0.3}) add_box({0.05, 0.05, 0.7}, {x, y, 0.35}, 1000, generator, cloud);
  return scan_of(std::move(cloud));
}

TEST(Rivals, ATableIsAmbiguousFromEitherGuess) {
  for (const double angle_rad : {0.0, std::numbers::pi}) {
    SCOPED_TRACE(angle_rad);
    Scan source = table(1);
    source.cloud = transform(source.cloud, inverse(kTrueMotion));
    const Rigid3 guess{rotation_exp({0.0, 0.0, angle_rad}), Vec3d::Zero()};
    EXPECT_EQ(register_scans(std::move(source), table(2), guess).result.status, AlignStatus::Ambiguous);
  }
}

// Arms about a hub, one at each of these angles, radians.
Scan star(const std::vector<double>& angles_rad, unsigned seed) {
  std::mt19937 generator(seed);
  Cloud cloud;
  for (const double angle_rad : angles_rad) {
    Cloud arm;
    add_box({0.8, 0.15, 0.1}, {0.6, 0.0, 0.0}, 3000, generator, arm);
    const Cloud turned = transform(arm, {rotation_exp({0.0, 0.0, angle_rad}), Vec3d::Zero()});
    cloud.points.insert(cloud.points.end(), turned.points.begin(), turned.points.end());
  }
  return scan_of(std::move(cloud));
}

// Neither quarter nor half turns: the same after a fifth of a turn, unless an arm is missing.
TEST(Rivals, FiveArmsAreAmbiguousAndFourOfThemAreNot) {
  const double fifth = 0.4 * std::numbers::pi;
  for (const bool is_whole : {true, false}) {
    std::vector<double> angles_rad{0.0, fifth, 2.0 * fifth, 3.0 * fifth};
    if (is_whole) angles_rad.push_back(4.0 * fifth);
    Scan source = star(angles_rad, 1);
    source.cloud = transform(source.cloud, inverse(kTrueMotion));
    const AlignResult result = register_scans(std::move(source), star(angles_rad, 2)).result;
    EXPECT_THAT(result.target_from_source, NearPose(kTrueMotion, 0.01, 0.02));
    EXPECT_EQ(result.status, is_whole ? AlignStatus::Ambiguous : AlignStatus::Converged);
  }
}

// It fits all four lower corners of the box. Three planes are a doubt of a pose far from the guess, as its rivals are:
// they count as if they were as near as it is.
TEST(Rivals, ACornerOfABoxIsAmbiguousThoughTheGuessIsNear) {
  const Cloud whole = room(true, 1).cloud;
  Cloud corner;
  for (const Vec3f& point : whole.points)
    if (point.x() > -1.0f && point.y() > -0.5f && point.z() < 1.0f) corner.points.push_back(point);
  const AlignResult result = register_scans(scan_of(transform(corner, inverse(kTrueMotion))), room(true, 2)).result;
  EXPECT_THAT(result.target_from_source, NearPose(kTrueMotion, 0.01, 0.02));
  EXPECT_LT(result.evidence->beyond_planes, 0.001);
  EXPECT_EQ(result.status, AlignStatus::Ambiguous);
}

// The axes of a scene turn with it, up to their order and signs.
TEST(SceneAxes, TurnWithTheScene) {
  const RegistrationOptions options;
  for (const Vec3d& turn : {Vec3d(0.0, 0.0, 0.0), Vec3d(0.3, -0.8, 0.5), Vec3d(-1.2, 0.1, 0.9)}) {
    const Rigid3 b_from_a{rotation_exp(turn), {1.0, 2.0, 3.0}};
    Scan moved = scan_of(transform(room(false, 3).cloud, b_from_a));
    const Cloud cloud = prepare_pair(moved, moved, options).target.cloud;
    const Mat3d in_room = b_from_a.rotation.toRotationMatrix().transpose() * scene_axes(cloud);
    EXPECT_LT((in_room.transpose() * in_room - Mat3d::Identity()).norm(), 1e-9);
    for (int k = 0; k < 3; ++k) EXPECT_GT(in_room.col(k).cwiseAbs().maxCoeff(), std::cos(0.05)) << k;
  }
  EXPECT_EQ(scene_axes(Cloud{}), Mat3d::Identity());
}

TEST(DifferClearly, IsTheRootMeanSquareOfWhatPointsMove) {
  Cloud cloud;
  cloud.points = {{1, 0, 0}, {-1, 0, 0}, {0, 3, 0}};
  const Rigid3 moved{Eigen::Quaterniond::Identity(), {0.0, 0.3, 0.4}};
  EXPECT_FALSE(differ_clearly(cloud, {}, moved, 0.51));
  EXPECT_TRUE(differ_clearly(cloud, {}, moved, 0.49));
  const Rigid3 turned{rotation_exp({0.0, 0.0, std::numbers::pi}), Vec3d::Zero()};  // 2, 2 and 6 m
  EXPECT_TRUE(differ_clearly(cloud, {}, turned, std::sqrt(44.0 / 3.0) - 1e-6));
  EXPECT_FALSE(differ_clearly(cloud, {}, turned, std::sqrt(44.0 / 3.0) + 1e-6));
}

}  // namespace
}  // namespace augicp
