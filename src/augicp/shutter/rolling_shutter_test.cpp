// SPDX-License-Identifier: MIT
#include "augicp/shutter/rolling_shutter.h"

#include <gmock/gmock.h>

#include <cmath>

#include "augicp/geometry/rotation.h"
#include "augicp/testing/matchers.h"
#include "augicp/testing/poses.h"
#include "augicp/testing/rolling_camera.h"
#include "augicp/testing/scenes.h"

namespace augicp {
namespace {

using testing::awkward_poses;
using testing::NearPose;

TEST(PartOf, WholeAndNothingAreTheEnds) {
  for (const Rigid3& motion : awkward_poses()) {
    EXPECT_THAT(part_of(motion, 1.0), NearPose(motion, 1e-12, 1e-12));
    EXPECT_THAT(part_of(motion, 0.0), NearPose(Rigid3{}, 0.0, 0.0));
  }
}

TEST(PartOf, PartsOfATurnAddUp) {
  const Rigid3 turn{rotation_exp({0.3, -0.2, 0.5}), Vec3d::Zero()};
  EXPECT_THAT(part_of(turn, 0.3) * part_of(turn, 0.9), NearPose(part_of(turn, 1.2), 1e-12, 0.0));
  EXPECT_THAT(part_of(turn, -1.0), NearPose(inverse(turn), 1e-12, 0.0));
}

// A room seen row by row by a camera that rotates by 3 degrees and moves by 3 cm during a readout.
struct Skewed {
  Scan scan;
  Rigid3 world_from_middle;
  Rigid3 first_from_last{rotation_exp({0.03, 0.04, -0.02}), {0.02, -0.01, 0.02}};
  std::vector<Vec3d> seen_in_world;  // of every point of the scan
};

Skewed skewed_room() {
  Skewed skewed;
  const testing::Scene room = testing::room();
  const Pinhole camera = testing::kinect_like_camera(64);
  skewed.world_from_middle = room.world_from_camera;
  const DepthImage image = testing::render_rolling(room, camera, skewed.world_from_middle, skewed.first_from_last);
  std::vector<Rigid3> world_from_rows;
  for (int v = 0; v < camera.height; ++v) {
    const double share = (v + 0.5) / camera.height - 0.5;
    world_from_rows.push_back(room.world_from_camera *
                              Rigid3{rotation_exp(share * rotation_log(skewed.first_from_last.rotation)),
                                     share * skewed.first_from_last.translation});
  }
  skewed.scan = scan_of(image, camera);
  skewed.seen_in_world.resize(skewed.scan.cloud.size());
  for (int v = 0; v < camera.height; ++v)
    for (int u = 0; u < camera.width; ++u)
      if (const std::int32_t i = skewed.scan.view->index.at(u, v); i != IndexImage::kNone)
        skewed.seen_in_world[i] = world_from_rows[v] * skewed.scan.cloud.points[i].cast<double>();
  return skewed;
}

double rms_off(const Skewed& skewed, const Cloud& cloud) {
  double sum = 0.0;
  for (std::size_t i = 0; i < cloud.size(); ++i)
    sum += (skewed.world_from_middle * cloud.points[i].cast<double>() - skewed.seen_in_world[i]).squaredNorm();
  return std::sqrt(sum / static_cast<double>(cloud.size()));
}

TEST(WithoutSkew, PutsEveryRowWhereItWasSeen) {
  const Skewed skewed = skewed_room();
  ASSERT_GT(skewed.scan.cloud.size(), 3000u);
  EXPECT_GT(rms_off(skewed, skewed.scan.cloud), 0.01);
  EXPECT_LT(rms_off(skewed, without_skew(skewed.scan, skewed.first_from_last, 1).cloud), 1e-5);
}

TEST(WithoutSkew, GaussiansStayWithTheirPoints) {
  Skewed skewed = skewed_room();
  Cloud& cloud = skewed.scan.cloud;
  for (const Vec3f& point : cloud.points) cloud.gaussians.push_back({point, Eigen::Matrix3f::Identity()});
  const Cloud straight = without_skew(skewed.scan, skewed.first_from_last, 1).cloud;
  for (std::size_t i = 0; i < straight.size(); ++i) EXPECT_EQ(straight.gaussians[i].mean, straight.points[i]);
}

TEST(WithoutSkew, NoMotionChangesNothing) {
  const Skewed skewed = skewed_room();
  const Scan same = without_skew(skewed.scan, Rigid3{}, 1);
  EXPECT_EQ(same.cloud.points, skewed.scan.cloud.points);
  EXPECT_EQ(same.view->index.index, skewed.scan.view->index.index);
}

TEST(WithoutSkew, PixelsFollowTheirPoints) {
  const Skewed skewed = skewed_room();
  const Scan straight = without_skew(skewed.scan, skewed.first_from_last, 1);
  const Pinhole& camera = straight.view->camera;
  int num_seen = 0;
  for (int v = 0; v < camera.height; ++v)
    for (int u = 0; u < camera.width; ++u) {
      const std::int32_t i = straight.view->index.at(u, v);
      if (i == IndexImage::kNone) continue;
      const Vec3f& point = straight.cloud.points[i];
      EXPECT_NEAR(camera.fx * point.x() / point.z() + camera.cx, u, 0.501);
      EXPECT_NEAR(camera.fy * point.y() / point.z() + camera.cy, v, 0.501);
      ++num_seen;
    }
  EXPECT_GT(num_seen, 2500);
}

}  // namespace
}  // namespace augicp
