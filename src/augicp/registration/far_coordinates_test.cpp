// SPDX-License-Identifier: MIT
// robustness 15: offsets of 1e3, 1e6 and 1e7 m, read as files are read. The result is within 1e-6 m of the one without.
#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "augicp/io/cloud_from_points.h"
#include "augicp/registration/registration.h"
#include "augicp/testing/poses.h"
#include "augicp/testing/room_pair.h"

namespace augicp {
namespace {

constexpr double kOffsets[] = {1e3, 1e6, 1e7};

Vec3d shift_of(double offset) { return {offset, -0.7 * offset, 0.5 * offset}; }

// Rounded to a quarter of a millimetre, so that a double represents the moved points exactly at every offset.
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
  return register_scans(source, target, Rigid3{}, options).result;
}

// The largest distance between the images of a point of the cloud under the two poses, metres. Far from zero the
// translation of a pose alone has no meaning.
double largest_gap(const Rigid3& far, const Rigid3& near, const Vec3d& shift, const Cloud& source) {
  double largest = 0.0;
  for (const Vec3f& point : source.points) {
    const Vec3d place = source.origin + point.cast<double>();
    largest = std::max(largest, (far * (shift + place) - shift - near * place).norm());
  }
  return largest;
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
    EXPECT_LT(largest_gap(far.target_from_source, near.target_from_source, shift, source.cloud), 1e-6) << offset;
  }
}

TEST(FarCoordinates, PairsReadNearZeroGiveThatPoseWithinTheRoundingOfPairs) {
  const testing::ScanPair pair = room_clouds();
  const Scan source = read_with(Vec3d::Zero(), pair.source), target = read_with(Vec3d::Zero(), pair.target);
  const AlignResult near = registered(source, target);
  for (const double offset : kOffsets) {
    const Vec3d shift = shift_of(offset);
    const AlignResult far = registered(read_with(shift, pair.source), read_with(shift, pair.target));
    EXPECT_LT(largest_gap(far.target_from_source, near.target_from_source, shift, source.cloud), 2e-4) << offset;
  }
}

}  // namespace
}  // namespace augicp
