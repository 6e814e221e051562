// SPDX-License-Identifier: MIT
// The constraints of the third measurement, and that it changes nothing if it is off or missing.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "augicp/registration/registration.h"
#include "augicp/testing/matchers.h"
#include "augicp/testing/rendering.h"
#include "augicp/testing/scenes.h"

namespace augicp {
namespace {

constexpr int kGreyWidth = 200;
constexpr double kGreyNoise = 0.01;

using Brightness = double (*)(const Vec3d& point_in_world);

// Blots of some 20 cm.
double blots(const Vec3d& p) {
  return 0.5 + 0.2 * std::sin(9.0 * p.x() + 2.0 * p.z()) + 0.2 * std::cos(11.0 * p.z() - 4.0 * p.y());
}
double even(const Vec3d&) { return 0.5; }
double ramp(const Vec3d& p) { return 0.5 + 0.2 * p.z(); }

struct Exposure {
  double gain_offset = 0.0, noise = kGreyNoise;
  unsigned seed = 1;
};

Scan seen(const testing::Scene& scene, const Rigid3& world_from_camera, Brightness brightness,
          const Exposure& exposure) {
  const Pinhole camera = testing::kinect_like_camera(kGreyWidth);
  DepthImage depth = testing::render(scene, camera, camera.width, camera.height, world_from_camera).depth;
  const DepthImage exact = depth;
  testing::add_depth_noise(depth, testing::kKinectSigmaAt1m, exposure.seed);
  GreyImage grey{depth.width, depth.height, {}};
  std::mt19937 generator(exposure.seed);
  std::normal_distribution<double> noise(exposure.gain_offset, exposure.noise);
  for (int v = 0; v < depth.height; ++v)
    for (int u = 0; u < depth.width; ++u) {
      const Vec3d ray((u - camera.cx) / camera.fx, (v - camera.cy) / camera.fy, 1.0);
      const Vec3d place = world_from_camera * Vec3d(static_cast<double>(exact.at(u, v)) * ray);
      grey.value.push_back(static_cast<float>(brightness(place) + noise(generator)));
    }
  return scan_of(depth, grey, DepthCamera{camera, {}, 0.0});
}

const Rigid3 kSlidingMotion{Eigen::Quaterniond(Eigen::AngleAxisd(0.03, Vec3d(0.6, 0.0, 0.8))), {0.03, 0.02, 0.02}};

AlignResult aligned(const testing::Scene& scene, Brightness brightness, bool intensity, double offset = 0.0) {
  const Rigid3& place = scene.world_from_camera;
  RegistrationOptions options;
  options.intensity = intensity;
  return register_scans(seen(scene, place * kSlidingMotion, brightness, {offset, kGreyNoise, 2}),
                        seen(scene, place, brightness, {}), {}, options)
      .result;
}

TEST(IntensityChannel, ATexturedWallIsHeldAndABareOneIsNot) {
  const testing::Scene wall = testing::single_plane();
  const AlignResult held = aligned(wall, blots, true);
  EXPECT_EQ(held.status, AlignStatus::Converged);
  EXPECT_GT(held.num_intensity_pairs, held.num_pairs / 10);
  EXPECT_THAT(held.target_from_source, testing::NearPose(kSlidingMotion, 0.003, 0.005));
  EXPECT_TRUE(held.covariance.has_value());

  EXPECT_EQ(aligned(wall, blots, false).status, AlignStatus::Degenerate);
  const AlignResult bare = aligned(wall, even, true);
  EXPECT_EQ(bare.status, AlignStatus::Degenerate);
  EXPECT_EQ(bare.free_motions.size(), 3u);
}

// Without a camera gradients come from the points around, in space.
TEST(IntensityChannel, ATexturedWallOfBareCloudsIsHeldToo) {
  const testing::Scene wall = testing::single_plane();
  const Rigid3& place = wall.world_from_camera;
  const Scan source = scan_of(seen(wall, place * kSlidingMotion, blots, {0.0, kGreyNoise, 2}).cloud),
             target = scan_of(seen(wall, place, blots, {}).cloud);
  RegistrationOptions options;
  options.intensity = true;
  const AlignResult held = register_scans(source, target, {}, options).result;
  EXPECT_GT(held.num_intensity_pairs, held.num_pairs / 10);
  EXPECT_THAT(held.target_from_source, testing::NearPose(kSlidingMotion, 0.005, 0.01));
  EXPECT_EQ(register_scans(source, target).result.status, AlignStatus::Degenerate);
}

TEST(IntensityChannel, AnotherExposureDoesNotMoveTheWall) {
  const AlignResult held = aligned(testing::single_plane(), blots, true, 0.15);
  EXPECT_EQ(held.status, AlignStatus::Converged);
  EXPECT_THAT(held.target_from_source, testing::NearPose(kSlidingMotion, 0.003, 0.005));
}

// Up the ramp could as well be another exposure, and along it nothing changes.
TEST(IntensityChannel, AnEvenRampDoesNotHoldAWall) {
  EXPECT_EQ(aligned(testing::single_plane(), ramp, true).status, AlignStatus::Degenerate);
}

TEST(IntensityChannel, OffItChangesNoBit) {
  const testing::Scene scene = testing::room_corner();
  const Rigid3& place = scene.world_from_camera;
  Scan source = seen(scene, place * kSlidingMotion, blots, {}), target = seen(scene, place, blots, {});
  const AlignResult off = register_scans(source, target).result;
  source.cloud.intensities.clear();
  target.cloud.intensities.clear();
  const AlignResult without = register_scans(source, target).result;
  EXPECT_EQ(off.target_from_source.matrix(), without.target_from_source.matrix());
  EXPECT_EQ(off.information, without.information);
  EXPECT_EQ(off.num_intensity_pairs, 0);
}

TEST(IntensityChannel, WhereOneScanHasNoneItIsAbsentAndSaysSo) {
  const testing::Scene scene = testing::room_corner();
  const Rigid3& place = scene.world_from_camera;
  Scan source = seen(scene, place * kSlidingMotion, blots, {});
  const Scan target = seen(scene, place, blots, {});
  source.cloud.intensities.clear();
  RegistrationOptions with;
  with.intensity = true;
  const AlignResult asked = register_scans(source, target, {}, with).result,
                    not_asked = register_scans(source, target).result;
  EXPECT_EQ(asked.target_from_source.matrix(), not_asked.target_from_source.matrix());
  EXPECT_EQ(asked.num_intensity_pairs, 0);
}

TEST(IntensityChannel, SameBitsForAnyNumberOfThreads) {
  const testing::Scene scene = testing::single_plane();
  const Rigid3& place = scene.world_from_camera;
  const Scan source = seen(scene, place * kSlidingMotion, blots, {0.0, kGreyNoise, 2}),
             target = seen(scene, place, blots, {});
  std::vector<Mat4d> poses;
  for (const int num_threads : {1, 2, 3, 8}) {
    RegistrationOptions options;
    options.intensity = true;
    options.num_threads = num_threads;
    poses.push_back(register_scans(source, target, {}, options).result.target_from_source.matrix());
    EXPECT_EQ(poses.back(), poses.front());
  }
}

}  // namespace
}  // namespace augicp
