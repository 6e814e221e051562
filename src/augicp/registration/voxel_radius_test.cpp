// SPDX-License-Identifier: MIT
#include "augicp/registration/voxel_radius.h"

#include <gtest/gtest.h>

namespace augicp {
namespace {

// A square metre of points with this spacing, in the plane z = 0.
Scan square_of(double spacing) {
  Cloud cloud;
  for (double x = 0.0; x < 1.0; x += spacing)
    for (double y = 0.0; y < 1.0; y += spacing) cloud.points.push_back(Vec3d(x, y, 0.0).cast<float>());
  return scan_of(std::move(cloud));
}

TEST(VoxelRadius, AVoxelSizeAloneBringsTheRadius) {
  const Scan scan = square_of(0.004);
  const Lengths derived = derive_lengths(scan, scan);
  const double coarse = 2.0 * derived.voxel_size, between = 0.75 * derived.voxel_size;
  EXPECT_DOUBLE_EQ(radius_for(coarse, scan, scan, derived), coarse / derived.voxel_size * derived.radius);
  EXPECT_DOUBLE_EQ(radius_for(between, scan, scan, derived), between / derived.voxel_size * derived.radius);
  // Finer than the points are: four times their spacing.
  const double fine = radius_for(1e-4, scan, scan, derived);
  EXPECT_NEAR(fine, 4.0 * 0.004, 0.2 * 4.0 * 0.004);
  // The sparser of two decides, and no more than the derived radius.
  EXPECT_GT(radius_for(1e-4, scan, square_of(0.006), derived), fine);
  EXPECT_DOUBLE_EQ(radius_for(1e-4, scan, square_of(0.1), derived), derived.radius);
}

TEST(VoxelRadius, WithoutExtentNoVoxelBringsARadius) {
  Cloud equal;
  equal.points.assign(50, Vec3f::Ones());
  const Scan scan = scan_of(equal);
  EXPECT_EQ(radius_for(0.1, scan, scan, derive_lengths(scan, scan)), 0.0);
}

}  // namespace
}  // namespace augicp
