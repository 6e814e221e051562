// SPDX-License-Identifier: MIT
#include "augicp/registration/full_resolution.h"

#include <gtest/gtest.h>

#include "augicp/geometry/rotation.h"
#include "augicp/registration/registration.h"
#include "augicp/testing/degenerate_families.h"
#include "augicp/testing/room_pair.h"

namespace augicp {
namespace {

// Two samples of the plane z = 0, the source tilted by this angle about x.
PreparedPair planes(double tilt_rad) {
  const testing::DegenerateFamily plane = testing::degenerate_families().front();
  EXPECT_EQ(plane.name, "plane");
  std::mt19937 generator(1);
  const Rigid3 tilt{rotation_exp({tilt_rad, 0.0, 0.0}), Vec3d::Zero()};
  const Cloud target = testing::draw(plane, 6000, 0.0, generator);
  const Cloud source = transform(testing::draw(plane, 6000, 0.0, generator), inverse(tilt));
  return prepare_pair(scan_of(source), scan_of(target), {});
}

// Whatever start leads to the plane, and however large the rotation beside the free motions is.
TEST(FullResolution, AlongFreeMotionsTheResultIsAtTheGuess) {
  for (const double tilt_rad : {0.05, 0.5, 1.0}) {
    SCOPED_TRACE(tilt_rad);
    const PreparedPair pair = planes(tilt_rad);
    const Rigid3 tilt{rotation_exp({tilt_rad, 0.0, 0.0}), Vec3d::Zero()},
        along{rotation_exp({0.0, 0.0, 0.3}), {0.2, -0.1, 0.0}};
    const AlignResult result = FullResolution(pair, Rigid3{}, RegistrationOptions{}).from(along * tilt);
    ASSERT_EQ(result.status, AlignStatus::Degenerate);
    ASSERT_EQ(result.free_motions.size(), 3u);
    const Vec6d moved = increment_between(Rigid3{}, result.target_from_source);
    for (const int free : {0, 1, 5}) EXPECT_NEAR(moved[free], 0.0, 1e-4) << free;
    EXPECT_NEAR(moved[3], tilt_rad, 1e-3);
  }
}

// As from a search on few points: within a voxel of it.
TEST(FullResolution, AFewPointsRefineAPoseToWhereAllLead) {
  const testing::ScanPair room = testing::room_pair({rotation_exp({0.05, 0.02, -0.03}), {0.1, 0.0, 0.05}});
  const PreparedPair pair = prepare_pair(scan_of(room.source.cloud), scan_of(room.target.cloud), {});
  const FullResolution full(pair, std::nullopt, RegistrationOptions{});
  const Rigid3 found = full.from(room.target_from_source).target_from_source;
  const Rigid3 off = Rigid3{rotation_exp({0.02, -0.03, 0.02}), {0.1, -0.08, 0.06}} * found;
  EXPECT_TRUE(full.is_promising(full.refined(off)));
  EXPECT_LT(increment_between(full.refined(off), found).norm(), 0.2 * increment_between(off, found).norm());
}

}  // namespace
}  // namespace augicp
