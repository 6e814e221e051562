// SPDX-License-Identifier: MIT
#include "augicp/geometry/trajectory.h"

#include <gmock/gmock.h>

#include <limits>

#include "augicp/geometry/rotation.h"
#include "augicp/testing/matchers.h"

namespace augicp {
namespace {

using ::testing::HasSubstr;
using testing::NearPose;
using ::testing::Property;
using ::testing::Throws;

TEST(Trajectory, IsInOrderWhenStampsIncrease) {
  EXPECT_NO_THROW(check_order({}));
  EXPECT_NO_THROW(check_order({{1.0, {}}, {1.5, {}}}));
  const auto message = [](const char* part) {
    return Throws<std::invalid_argument>(Property(&std::invalid_argument::what, HasSubstr(part)));
  };
  EXPECT_THAT([] { check_order({{1.0, {}}, {1.0, {}}}); }, message("pose 1"));
  EXPECT_THAT(
      [] {
        check_order({{1.0, {}}, {2.0, {}}, {0.5, {}}});
      },
      message("found 0.500000 s after 2.000000 s at pose 2"));
  EXPECT_THAT([] { check_order({{std::numeric_limits<double>::quiet_NaN(), {}}}); }, message("pose 0"));
}

TEST(Trajectory, PoseBetweenTwoIsOnTheWay) {
  const Rigid3 first{rotation_exp({0.0, 0.0, 0.2}), {1.0, 0.0, 0.0}};
  const Rigid3 second{rotation_exp({0.0, 0.0, 0.6}), {2.0, 4.0, 0.0}};
  const Trajectory trajectory = {{10.0, first}, {14.0, second}};
  const auto pose = pose_at(trajectory, 11.0, 5.0);
  ASSERT_TRUE(pose);
  EXPECT_THAT(*pose, NearPose(Rigid3{rotation_exp({0.0, 0.0, 0.3}), {1.25, 1.0, 0.0}}, 1e-12, 1e-12));
  EXPECT_THAT(*pose_at(trajectory, 10.0, 5.0), NearPose(first, 0.0, 1e-15));
  EXPECT_THAT(*pose_at(trajectory, 14.0, 5.0), NearPose(second, 0.0, 1e-15));
}

TEST(Trajectory, HasNoPoseOutsideOrInAGap) {
  const Trajectory trajectory = {{10.0, {}}, {14.0, {}}};
  EXPECT_FALSE(pose_at(trajectory, 9.9, 5.0));
  EXPECT_FALSE(pose_at(trajectory, 14.1, 5.0));
  EXPECT_FALSE(pose_at(trajectory, 12.0, 3.9));
  EXPECT_TRUE(pose_at(trajectory, 12.0, 4.0)) << "no more than the gap allowed";
  EXPECT_TRUE(pose_at(trajectory, 14.0, 3.9)) << "a pose that is there needs no neighbour";
  EXPECT_FALSE(pose_at({}, 1.0, 5.0));
}

TEST(Trajectory, ArcIsTheShortestForEitherSignOfTheQuaternion) {
  Rigid3 turned{rotation_exp({0.4, 0.0, 0.0}), Vec3d::Zero()};
  const Rigid3 half = interpolate({}, turned, 0.5);
  turned.rotation.coeffs() *= -1.0;
  EXPECT_THAT(interpolate({}, turned, 0.5), NearPose(half, 1e-12, 1e-12));
}

}  // namespace
}  // namespace augicp
