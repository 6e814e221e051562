// SPDX-License-Identifier: MIT
#include "augicp/trust/covariance.h"

#include <gtest/gtest.h>

#include <Eigen/Cholesky>

#include "augicp/geometry/rotation.h"
#include "augicp/registration/registration.h"
#include "augicp/testing/room_pair.h"
#include "augicp/testing/scenes.h"

namespace augicp {
namespace {

const Rigid3 kDrawnMotion{rotation_exp({0.03, -0.03, 0.02}), {0.02, 0.03, -0.03}};

AlignResult noisy(const testing::Scene& scene, unsigned seed, bool as_clouds = false) {
  const Rigid3& place = scene.world_from_camera;
  const Scan source = testing::noisy_view(scene, place * kDrawnMotion, 2 * seed + 1, 80);
  const Scan target = testing::noisy_view(scene, place, 2 * seed + 2, 80);
  return as_clouds ? register_scans(scan_of(source.cloud), scan_of(target.cloud)).result
                   : register_scans(source, target).result;
}

TEST(Covariance, IsSymmetricAndPositive) {
  const AlignResult result = noisy(testing::room(), 1);
  ASSERT_TRUE(result.covariance);
  EXPECT_EQ(*result.covariance, result.covariance->transpose());
  EXPECT_EQ(result.covariance->llt().info(), Eigen::Success);
}

TEST(Covariance, OfADegenerateProblemThereIsNone) { EXPECT_FALSE(noisy(testing::single_plane(), 1).covariance); }

// The squared errors of runs about their mean, normalised by the stated covariance: 1 if it is right. 20 runs give it
// to 0.13.
TEST(Covariance, TellsTheSpreadOfErrors) {
  constexpr int kRuns = 20;
  for (const bool as_clouds : {false, true}) {
    std::vector<Vec6d> errors;
    Vec6d mean = Vec6d::Zero();
    Mat6d told = Mat6d::Zero(), spread = Mat6d::Zero();
    for (unsigned seed = 0; seed < kRuns; ++seed) {
      const AlignResult result = noisy(testing::room(), seed, as_clouds);
      ASSERT_TRUE(result.covariance);
      told += *result.covariance / kRuns;
      errors.push_back(increment_between(kDrawnMotion, result.target_from_source));
      mean += errors.back() / kRuns;
    }
    for (const Vec6d& error : errors) spread += (error - mean) * (error - mean).transpose() / (kRuns - 1);
    const double spread_per_told = told.ldlt().solve(spread).trace() / 6.0;
    EXPECT_GT(spread_per_told, 0.55) << as_clouds;
    EXPECT_LT(spread_per_told, 1.45) << as_clouds;
  }
}

// An increment moves a point by t + r x place, so that is its translation about the point.
TEST(Covariance, AboutAnotherPointIsThatOfTheSameMotions) {
  const Vec3d offset(3.0, -2.0, 0.5);
  for (int k = 0; k < 6; ++k) {
    Vec6d increment = 0.1 * Vec6d::Ones();
    increment[k] = -1.0;
    Vec6d about = increment;
    about.head<3>() += increment.tail<3>().cross(offset);
    const Mat6d covariance = increment * increment.transpose();
    EXPECT_LT((covariance_about(covariance, offset) - about * about.transpose()).norm(), 1e-12);
    EXPECT_LT((covariance_about(covariance_about(covariance, offset), -offset) - covariance).norm(), 1e-12);
  }
}

// Of the covariance of one increment it is what that increment does, to first order: t + r x place.
TEST(Covariance, MovesPointsAsItsIncrementsDo) {
  Cloud cloud;
  cloud.points = {{1.0f, 2.0f, -3.0f}, {4.0f, 2.5f, -3.0f}, {1.5f, 6.0f, 0.5f}, {-2.0f, 0.0f, 1.0f}};
  for (int k = 0; k < 6; ++k) {
    Vec6d increment = 0.1 * Vec6d::Ones();
    increment[k] = -1.0;
    double sum_sq = 0.0;
    for (const Vec3f& point : cloud.points)
      sum_sq += (increment.head<3>() + increment.tail<3>().cross(point.cast<double>())).squaredNorm();
    EXPECT_NEAR(rms_motion(increment * increment.transpose(), cloud), std::sqrt(sum_sq / 4.0), 1e-9);
  }
  EXPECT_EQ(rms_motion(Mat6d::Identity(), {}), 0.0);
}

}  // namespace
}  // namespace augicp
