// SPDX-License-Identifier: MIT
#include "augicp/trust/contradiction.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <random>

#include "augicp/geometry/rotation.h"
#include "augicp/match/matcher.h"

namespace augicp {
namespace {

constexpr double kSpacing = 0.02, kRadius = 0.06;  // metres
constexpr AgreementTolerance kTolerance{.distance = 0.03};

using Wanted = std::function<bool(const Vec3f&)>;
bool everywhere(const Vec3f&) { return true; }

// A floor of 1 m x 1 m, sampled at random where wanted.
Cloud floor(unsigned seed, const Wanted& is_wanted = everywhere) {
  std::mt19937 generator(seed);
  std::uniform_real_distribution<float> uniform(-0.5f, 0.5f);
  Cloud cloud;
  for (int k = 0; k < 2500; ++k) {
    const Vec3f point(uniform(generator), uniform(generator), 0.0f);
    if (is_wanted(point)) cloud.points.push_back(point);
  }
  return cloud;
}

// Floor and an upright post of 0.1 m x 0.3 m on it at x.
Cloud floor_and_post(unsigned seed, float x) {
  Cloud cloud = floor(seed);
  for (double z = 0.5 * kSpacing; z < 0.3; z += kSpacing)
    for (double y = -0.05; y < 0.05; y += kSpacing)
      cloud.points.emplace_back(x, static_cast<float>(y), static_cast<float>(z));
  return cloud;
}

double share(const Cloud& cloud, const Cloud& other, const Rigid3& other_from_cloud = {}) {
  const auto said = NearestMatcher(other).agreements(cloud, other_from_cloud, kTolerance, 1);
  return contradicting_share(cloud, said, {other, other_from_cloud, kRadius});
}

TEST(Contradiction, TheSameSurfaceSampledTwiceHasNone) {
  EXPECT_EQ(share(floor(1), floor(2)), 0.0);
  EXPECT_EQ(share(floor_and_post(1, 0.2f), floor_and_post(2, 0.2f)), 0.0);
}

// All of the post but its foot, where it agrees with the floor.
TEST(Contradiction, APostOnAFloorThatGoesOnIsOne) {
  const Cloud post = floor_and_post(1, 0.2f);
  const double num_on_post = static_cast<double>(post.size() - floor(1).size());
  const double part = share(post, floor(2)) * static_cast<double>(post.size());
  EXPECT_LE(part, num_on_post);
  EXPECT_GT(part, 0.8 * num_on_post);
  EXPECT_GT(share(post, floor_and_post(2, -0.2f)), 0.0);
  EXPECT_GT(share(floor_and_post(2, -0.2f), post), 0.0);
}

TEST(Contradiction, MovingBothCloudsChangesNothing) {
  const Cloud post = floor_and_post(1, 0.2f);
  const Rigid3 motion{rotation_exp(Vec3d(0.4, -0.7, 1.1)), {0.3, -0.2, 0.5}};
  Cloud moved;
  for (const Vec3f& point : floor(2).points) moved.points.push_back((motion * point.cast<double>()).cast<float>());
  EXPECT_NEAR(share(post, moved, motion), share(post, floor(2)), 0.002);
}

// The floor beyond what the other scan reached begins at its border; so does what fills its hole.
TEST(Contradiction, WhatTheOtherScanDidNotReachIsNone) {
  EXPECT_EQ(share(floor(1), floor(2, [](const Vec3f& p) { return p.x() < 0.0f; })), 0.0);
  EXPECT_EQ(share(floor(1), floor(2, [](const Vec3f& p) { return p.norm() > 0.2f; })), 0.0);
}

// The post stands in a hole of the other floor, as what a scan saw of a thing's shadow.
TEST(Contradiction, APostInAHoleIsNone) {
  const auto is_far = [](const Vec3f& p) { return (p - Vec3f(0.2f, 0.0f, 0.0f)).norm() > 0.12f; };
  EXPECT_EQ(share(floor_and_post(1, 0.2f), floor(2, is_far)), 0.0);
}

// A wall along x or y of this height, upright on the floor.
void add_wall(Cloud& cloud, const Vec3f& from, const Vec3f& to) {
  constexpr float kStep = static_cast<float>(kSpacing);
  const float length = (to - from).norm();
  for (float z = 0.5f * kStep; z < 0.3f; z += kStep)
    for (float s = 0.0f; s < length; s += kStep)
      cloud.points.emplace_back(from + s / length * (to - from) + Vec3f(0.0f, 0.0f, z));
}

// The other scan reaches up to y = 0.3 and shows a bare floor. A wall across that floor is linked with what is beyond.
TEST(Contradiction, AWallAcrossAFloorIsOneAndWhatIsLinkedWithItBeyondTheScanIsNot) {
  const Cloud other = floor(2, [](const Vec3f& p) { return p.y() < 0.3f; });
  Cloud cloud = floor(1);
  add_wall(cloud, {-0.5f, 0.45f, 0.0f}, {0.5f, 0.45f, 0.0f});
  EXPECT_EQ(share(cloud, other), 0.0);
  const double num_before = static_cast<double>(cloud.size());
  add_wall(cloud, {0.2f, -0.3f, 0.0f}, {0.2f, 0.44f, 0.0f});
  const double num_across = static_cast<double>(cloud.size()) - num_before;
  const double part = share(cloud, other) * static_cast<double>(cloud.size());
  EXPECT_GT(part, 0.4 * num_across);  // counted by 0.6
  EXPECT_LT(part, 0.7 * num_across);
}

TEST(Contradiction, ScanLinesFarApartContradictNothing) {
  Cloud lines;
  for (float y = -0.45f; y < 0.5f; y += 0.1f)
    for (float x = -0.5f; x < 0.5f; x += 0.004f) lines.points.emplace_back(x, y, 0.0f);
  EXPECT_EQ(share(floor_and_post(1, 0.2f), lines), 0.0);
}

TEST(Contradiction, AFewPointsAreNoise) {
  Cloud noisy = floor(1);
  for (int k = 0; k < 4; ++k) noisy.points.emplace_back(0.2f, 0.0f, 0.03f + 0.01f * static_cast<float>(k));
  EXPECT_EQ(share(noisy, floor(2)), 0.0);
}

TEST(Contradiction, EmptyCloudsHaveNone) {
  EXPECT_EQ(share({}, floor(1)), 0.0);
  EXPECT_EQ(share(floor(1), {}), 0.0);
}

}  // namespace
}  // namespace augicp
