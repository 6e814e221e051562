// SPDX-License-Identifier: MIT
#include "augicp/registration/start/principal_axis.h"

#include <gtest/gtest.h>

#include <cmath>

#include "augicp/geometry/rotation.h"
#include "augicp/testing/random_clouds.h"

namespace augicp {
namespace {

// Random points in a box of this size about a place.
Cloud box(const Vec3f& size, const Vec3f& place) {
  Cloud cloud = testing::random_points(4000, 1.0, 5);
  for (Vec3f& point : cloud.points) point = place + point.cwiseProduct(size);
  return cloud;
}

TEST(PrincipalAxis, IsThatOfTheMomentThatDiffers) {
  const Vec3f place(3.0f, -2.0f, 1.0f);
  const RotationAxis of_plate = principal_axis(box({1.0f, 1.0f, 0.1f}, place));
  EXPECT_GT(std::abs(of_plate.direction.z()), 0.999);
  EXPECT_LT((of_plate.place - place.cast<double>()).norm(), 0.05);
  EXPECT_GT(std::abs(principal_axis(box({2.0f, 0.3f, 0.3f}, place)).direction.x()), 0.999);
}

TEST(PrincipalAxis, RotatesWithTheCloud) {
  const Rigid3 moved{rotation_exp({0.4, -0.9, 0.2}), Vec3d::Zero()};
  const RotationAxis axis = principal_axis(transform(box({1.0f, 1.0f, 0.1f}, Vec3f::Zero()), moved));
  EXPECT_GT(std::abs(axis.direction.dot(moved.rotation * Vec3d::UnitZ())), 0.999);
}

TEST(PrincipalAxis, DoesNotFollowOutliers) {
  Cloud cloud = box({1.0f, 1.0f, 0.1f}, Vec3f::Zero());
  for (int k = 0; k < 20; ++k) cloud.points.emplace_back(0.0f, 5.0f, 20.0f);
  const RotationAxis axis = principal_axis(cloud);
  EXPECT_GT(std::abs(axis.direction.z()), 0.999);
  EXPECT_LT(axis.place.norm(), 0.05);
}

TEST(PrincipalAxis, OfOnePointIsAnyLineThroughIt) {
  Cloud cloud;
  cloud.points.assign(1, Vec3f(1.0f, 2.0f, 3.0f));
  EXPECT_EQ(principal_axis(cloud).place, Vec3d(1.0, 2.0, 3.0));
  EXPECT_NEAR(principal_axis(cloud).direction.norm(), 1.0, 1e-12);
}

}  // namespace
}  // namespace augicp
