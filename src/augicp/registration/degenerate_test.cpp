// SPDX-License-Identifier: MIT
// robustness 12: scenes that leave a motion open. It is named, it stays at the guess, and the rest is found.
#include <gtest/gtest.h>

#include <cmath>

#include "augicp/registration/registration.h"
#include "augicp/testing/degenerate_families.h"
#include "augicp/testing/poses.h"
#include "augicp/testing/rendering.h"
#include "augicp/testing/repeats.h"
#include "augicp/testing/scenes.h"

namespace augicp {
namespace {

using Kind = FreeMotion::Kind;

constexpr double kDegree = 3.14159265358979 / 180.0;

struct Family {
  const char* name;
  testing::Scene scene;
  int num_translations, num_turns;
  Vec3d axis_in_world;  // of the turn, or else of the translation; zero: any
};

std::vector<Family> families() {
  const Vec3d wall = Vec3d(0.3, -1.0, 0.2).normalized();
  return {{"plane", testing::single_plane(), 2, 1, wall},
          {"two parallel planes", testing::two_parallel_planes(), 2, 1, Vec3d::UnitY()},
          {"corridor", testing::corridor(), 1, 0, Vec3d::UnitY()},
          {"cylinder", testing::cylinder_scene(), 1, 1, Vec3d::UnitZ()},
          {"sphere", testing::sphere_scene(), 0, 3, Vec3d::Zero()}};
}

Scan seen(const testing::Scene& scene, const Rigid3& world_from_camera, double noise, unsigned seed) {
  const Pinhole camera = testing::kinect_like_camera(320);
  DepthImage image = testing::render(scene, camera, camera.width, camera.height, world_from_camera).depth;
  if (noise > 0.0) testing::add_depth_noise(image, noise, seed);
  return scan_of(image, camera);
}

AlignResult aligned(const Family& family, const Rigid3& motion, double noise, unsigned seed,
                    Method method = Method::Augmented) {
  const Rigid3& place = family.scene.world_from_camera;
  RegistrationOptions options;
  options.method = method;
  return register_scans(seen(family.scene, place * motion, noise, seed + 100), seen(family.scene, place, noise, seed),
                        {}, options)
      .result;
}

int num_of(const AlignResult& result, bool turns) {
  int count = 0;
  for (const FreeMotion& motion : result.free_motions) count += (motion.kind != Kind::Translation) == turns;
  return count;
}

void expect_names(const Family& family, const AlignResult& result) {
  ASSERT_EQ(result.status, AlignStatus::Degenerate) << family.name;
  EXPECT_EQ(num_of(result, false), family.num_translations) << family.name;
  EXPECT_EQ(num_of(result, true), family.num_turns) << family.name;
  const Vec3d axis = inverse(family.scene.world_from_camera).rotation * family.axis_in_world;
  for (const FreeMotion& motion : result.free_motions) {
    const bool is_the_one = family.num_turns == 0 || motion.kind != Kind::Translation;
    if (axis.norm() > 0.0 && is_the_one) {
      EXPECT_GT(std::abs(motion.axis.dot(axis)), std::cos(5.0 * kDegree)) << family.name;
    }
  }
}

TEST(Degenerate, ExactScenesNameWhatIsFree) {
  for (const Family& family : families()) expect_names(family, aligned(family, {}, 0.0, 1));
}

TEST(Degenerate, NoisyScenesNameWhatIsFree) {
  for (const Family& family : families())
    for (const unsigned seed : testing::cases({1u, 2u, 3u}, 1))
      expect_names(family, aligned(family, {}, testing::kKinectSigmaAt1m, seed));
}

// A wall: its distance and its normal are found; along it and about its normal the pose stays at the guess.
TEST(Degenerate, AWallHoldsThreeMotionsAndLeavesThree) {
  const Family wall = families().front();
  const Rigid3 motion{Eigen::Quaterniond(Eigen::AngleAxisd(0.05, Vec3d(0.6, 0.0, 0.8))), {0.03, 0.02, 0.05}};
  const Vec3d normal = inverse(wall.scene.world_from_camera).rotation * wall.axis_in_world;
  for (const Method method : {Method::Augmented, Method::Ndt})
    for (const double noise : testing::cases({testing::kKinectSigmaAt1m, 0.0}, 1)) {
      const AlignResult result = aligned(wall, motion, noise, 1, method);
      ASSERT_EQ(result.status, AlignStatus::Degenerate);
      const Rigid3& found = result.target_from_source;
      const Rigid3 wrong = inverse(motion) * found;
      const Vec3d turned = wrong.rotation * normal;
      EXPECT_LT(std::acos(std::min(1.0, turned.dot(normal))), 0.2 * kDegree) << noise;
      // Seen along the optical axis, with the wall about 2 m away.
      const Vec3d middle(0.0, 0.0, 2.0);
      EXPECT_NEAR(normal.dot(found * middle - motion * middle), 0.0, 0.005) << noise;
      // Free motions are zero, except for the effect of the wall's rotation.
      const Eigen::AngleAxisd turn(found.rotation);
      EXPECT_LT(std::abs(turn.angle() * turn.axis().dot(normal)), 0.5 * kDegree) << noise;
    }
}

TEST(Degenerate, ACorridorStaysAtTheGuessAlongItself) {
  const Family corridor = families()[2];
  const Rigid3 motion{Eigen::Quaterniond(Eigen::AngleAxisd(0.04, Vec3d(0.6, 0.8, 0.0))), {0.04, 0.03, 0.1}};
  const Vec3d along = inverse(corridor.scene.world_from_camera).rotation * Vec3d::UnitY();
  const AlignResult result = aligned(corridor, motion, testing::kKinectSigmaAt1m, 1);
  ASSERT_EQ(result.status, AlignStatus::Degenerate);
  const Vec3d left = result.target_from_source.translation - motion.translation;
  EXPECT_LT((left - along * along.dot(left)).norm(), 0.02);
  EXPECT_LT(angle_between(result.target_from_source, motion), 0.3 * kDegree);
  EXPECT_LT(std::abs(along.dot(result.target_from_source.translation)), 0.03);
}

TEST(Degenerate, AWholeRoomHoldsAllAndNamesNothing) {
  const Family room{"room", testing::room(), 0, 0, Vec3d::Zero()};
  const AlignResult result = aligned(room, {}, testing::kKinectSigmaAt1m, 1);
  EXPECT_EQ(result.status, AlignStatus::Converged);
  EXPECT_TRUE(result.free_motions.empty());
}

// Two drawings of each shape as bare clouds, exact and with noise: the motions named are free, and all that are.
TEST(Degenerate, BareCloudsOfTwelveShapesNameWhatIsFree) {
  constexpr std::size_t kPoints = 4000;
  for (const testing::DegenerateFamily& family : testing::degenerate_families())
    for (const double noise : {0.0, family.noise}) {
      std::mt19937 generator(1);
      const Rigid3 motion = testing::random_motion(generator, 0.03, 0.03);
      const Cloud target = testing::draw(family, kPoints, noise, generator);
      const Cloud source = transform(testing::draw(family, kPoints, noise, generator), inverse(motion));
      const AlignResult result = register_scans(scan_of(source), scan_of(target)).result;
      EXPECT_EQ(result.status, AlignStatus::Degenerate) << family.name << " " << noise;
      ASSERT_EQ(result.free_motions.size(), family.free_motions.size()) << family.name << " " << noise;
      const Observability& seen = result.observability;
      std::vector<Vec6d> found;
      for (Eigen::Index k = 0; k < static_cast<Eigen::Index>(family.free_motions.size()); ++k)
        found.push_back(seen.directions.col(k));
      EXPECT_LT(testing::angle_to_free(family, found, seen.gyration, seen.centroid), 5.0 * kDegree)
          << family.name << " " << noise;
      const Vec6d left = increment_between(motion, result.target_from_source);
      EXPECT_LT(testing::held_part(family, left, seen.gyration, seen.centroid), 0.002) << family.name << " " << noise;
    }
}

// A screw as a helix would leave it, put together by hand.
TEST(FreeMotions, AScrewHasAnAxisAndAPitch) {
  Observability observability;
  observability.gyration = 2.0;
  observability.centroid = Vec3d(5, 0, 0);
  // About the z axis through (1, 0, 0), by 0.5 m a radian: the zero moves by -w x p + pitch w.
  Vec6d screw;
  screw << Vec3d(1, 0, 0).cross(Vec3d::UnitZ()) + 0.5 * Vec3d::UnitZ(), Vec3d::UnitZ();
  observability.directions.col(0) = screw;
  const std::vector<FreeMotion> motions = free_motions(observability, 1);
  ASSERT_EQ(motions.size(), 1u);
  EXPECT_EQ(motions[0].kind, Kind::Screw);
  EXPECT_NEAR(std::abs(motions[0].axis.z()), 1.0, 1e-12);
  EXPECT_NEAR(motions[0].pitch, 0.5, 1e-12);
  EXPECT_NEAR((motions[0].point - Vec3d(1, 0, 0)).norm(), 0.0, 1e-12);
}

}  // namespace
}  // namespace augicp
