// SPDX-License-Identifier: MIT
// robustness 15: offsets of 1e3, 1e6 and 1e7 m, read as files are read. The result is within 1e-6 m of the one without.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <random>

#include "augicp/io/cloud_from_points.h"
#include "augicp/registration/registration.h"
#include "augicp/testing/matchers.h"
#include "augicp/testing/poses.h"
#include "augicp/testing/room_pair.h"

namespace augicp {
namespace {

constexpr double kOffsets[] = {1e3, 1e6, 1e7};

Vec3d shift_of(double offset) { return {offset, -0.7 * offset, 0.5 * offset}; }

// Rounded to a quarter of a millimetre, so that a double holds the moved points exactly at every offset.
Scan read_with(const Vec3d& shift, const Scan& scan) {
  constexpr double kStep = 1.0 / 4096.0;
  PointSource points;
  points.count = scan.cloud.size();
  points.position = [&](std::size_t i) -> Vec3d {
    return shift + (scan.cloud.points[i].cast<double>() / kStep).array().round().matrix() * kStep;
  };
  return scan_of(cloud_from_points(points).cloud);
}

testing::ScanPair room_clouds() {
  std::mt19937 generator(3);
  return testing::room_pair(testing::random_motion(generator, 0.1, 0.1));
}

AlignResult registered(const Scan& source, const Scan& target) {
  RegistrationOptions options;
  options.search = false;  // the guess is near enough
  return register_scans(source, target, Rigid3{}, options);
}

// Where the pose brings the points of the cloud: far from zero a pose's own translation says nothing.
void expect_same_places(const Rigid3& far, const Rigid3& near, const Vec3d& shift, const Cloud& source,
                        double tolerance_m = 1e-6) {
  for (const Vec3f& point : source.points) {
    const Vec3d place = source.origin + point.cast<double>();
    ASSERT_THAT(far * (shift + place) - shift, testing::NearVector(near * place, tolerance_m));
  }
}

// The un-offset pair has the same points about an origin that is nearer. Read near zero they would have none, be
// rounded otherwise, and now and then a pair at a gate would be another: that is some 1e-5 m, at any distance from
// zero.
TEST(FarCoordinates, PairsFarFromZeroGiveTheSamePose) {
  const testing::ScanPair pair = room_clouds();
  for (const double offset : kOffsets) {
    const Vec3d shift = shift_of(offset);
    const Scan far_source = read_with(shift, pair.source), far_target = read_with(shift, pair.target);
    Scan source = far_source, target = far_target;
    source.cloud.origin -= shift;
    target.cloud.origin -= shift;
    ASSERT_LT(source.cloud.origin.norm(), 10.0);
    const AlignResult far = registered(far_source, far_target), near = registered(source, target);
    EXPECT_EQ(far.status, AlignStatus::Converged) << offset;
    expect_same_places(far.target_from_source, near.target_from_source, shift, source.cloud);
  }
}

TEST(FarCoordinates, PairsReadNearZeroGiveThatPoseWithinTheRoundingOfPairs) {
  constexpr double kTolerance_m = 2e-4;
  const testing::ScanPair pair = room_clouds();
  const Scan source = read_with(Vec3d::Zero(), pair.source), target = read_with(Vec3d::Zero(), pair.target);
  const AlignResult near = registered(source, target);
  for (const double offset : kOffsets) {
    const Vec3d shift = shift_of(offset);
    const AlignResult far = registered(read_with(shift, pair.source), read_with(shift, pair.target));
    expect_same_places(far.target_from_source, near.target_from_source, shift, source.cloud, kTolerance_m);
  }
}

}  // namespace
}  // namespace augicp
