// SPDX-License-Identifier: MIT
#include "augicp/align/covariance.h"

#include <gtest/gtest.h>

#include <Eigen/Cholesky>

#include "augicp/geometry/rotation.h"
#include "augicp/registration/registration.h"
#include "augicp/testing/poses.h"
#include "augicp/testing/rendering.h"
#include "augicp/testing/scenes.h"

namespace augicp {
namespace {

struct Views {
  Pinhole camera = testing::kinect_like_camera(120);
  DepthImage source, target;
  Rigid3 target_from_source;
};

Views views_of(const testing::Scene& scene) {
  Views views;
  std::mt19937 generator(7);
  views.target_from_source = testing::random_motion(generator, 0.05, 0.05);
  const Rigid3& place = scene.world_from_camera;
  const Pinhole& camera = views.camera;
  views.target = testing::render(scene, camera, camera.width, camera.height, place).depth;
  views.source = testing::render(scene, camera, camera.width, camera.height, place * views.target_from_source).depth;
  return views;
}

AlignResult noisy(const Views& views, unsigned seed) {
  DepthImage source = views.source, target = views.target;
  testing::add_depth_noise(source, testing::kKinectSigmaAt1m, 2 * seed + 1);
  testing::add_depth_noise(target, testing::kKinectSigmaAt1m, 2 * seed + 2);
  return register_scans(scan_of(source, views.camera), scan_of(target, views.camera));
}

TEST(Covariance, IsSymmetricAndPositive) {
  const AlignResult result = noisy(views_of(testing::room()), 1);
  ASSERT_TRUE(result.covariance);
  EXPECT_EQ(*result.covariance, result.covariance->transpose());
  EXPECT_EQ(result.covariance->llt().info(), Eigen::Success);
}

TEST(Covariance, OfADegenerateProblemThereIsNone) {
  EXPECT_FALSE(noisy(views_of(testing::single_plane()), 1).covariance);
}

// The normalised error squared, over six: 1 where the covariance is right. Of 30 runs its mean is known to a tenth.
TEST(Covariance, TellsTheErrorsOfNoisyImages) {
  for (const testing::Scene& scene : {testing::room(1), testing::room_corner()}) {
    const Views views = views_of(scene);
    constexpr int kRuns = 30;
    double sum = 0.0;
    for (unsigned seed = 0; seed < kRuns; ++seed) {
      const AlignResult result = noisy(views, seed);
      ASSERT_TRUE(result.covariance);
      const Rigid3 error = result.target_from_source * inverse(views.target_from_source);
      const Eigen::AngleAxisd turn(error.rotation);
      Vec6d increment;
      increment << error.translation, turn.angle() * turn.axis();
      sum += increment.dot(result.covariance->ldlt().solve(increment)) / 6.0;
    }
    EXPECT_GT(sum / kRuns, 0.6);
    EXPECT_LT(sum / kRuns, 1.7);
  }
}

}  // namespace
}  // namespace augicp
