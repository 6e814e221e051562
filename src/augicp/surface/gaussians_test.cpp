// SPDX-License-Identifier: MIT
#include "augicp/surface/gaussians.h"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <random>

#include "augicp/surface/ball_neighbourhood.h"
#include "augicp/surface/window_neighbourhood.h"
#include "augicp/testing/poses.h"
#include "augicp/testing/random_clouds.h"
#include "augicp/testing/rendering.h"
#include "augicp/testing/scenes.h"

namespace augicp {
namespace {

constexpr double kGaussianRadius = 0.3;

Cloud with_gaussians(Cloud cloud, double radius = kGaussianRadius, int num_threads = 1) {
  estimate_gaussians(cloud, BallNeighbourhood(cloud, {radius, 0, 0.0}, num_threads), radius, num_threads);
  return cloud;
}

double relative_difference(const Eigen::Matrix3f& a, const Eigen::Matrix3f& b) {
  return static_cast<double>((a - b).norm() / b.norm());
}

// Mean and covariance of the points in a ball, one after the other.
Gaussian plain_gaussian(const Cloud& cloud, const Vec3f& centre, double radius) {
  Gaussian plain;
  std::vector<Vec3d> inside;
  for (const Vec3f& point : cloud.points)
    if (static_cast<double>((point - centre).norm()) < radius) inside.push_back(point.cast<double>());
  plain.count = static_cast<double>(inside.size());
  for (const Vec3d& point : inside) plain.mean += point / plain.count;
  for (const Vec3d& point : inside)
    plain.covariance += (point - plain.mean) * (point - plain.mean).transpose() / plain.count;
  return plain;
}

TEST(Gaussians, AreThoseOfThePointsInTheBall) {
  const Cloud cloud = with_gaussians(testing::random_points(2000, 1.0, 1));
  std::size_t num_compared = 0;
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    const Gaussian plain = plain_gaussian(cloud, cloud.points[i], kGaussianRadius);
    if (plain.count < 8.0) continue;
    ++num_compared;
    const Mat3d expected = 0.25 * kGaussianRadius * kGaussianRadius * plain.covariance.inverse();
    EXPECT_LT((cloud.gaussians[i].mean.cast<double>() - plain.mean).norm(), 1e-6) << i;
    EXPECT_LT(relative_difference(cloud.gaussians[i].information, expected.cast<float>()), 1e-4) << i;
  }
  EXPECT_GT(num_compared, 1500u);
}

// Flat, 2 x 2 m: inside it every ball holds a disc.
Cloud flat_points(std::size_t count, unsigned seed) {
  Cloud cloud = testing::random_points(count, 1.0, seed);
  for (Vec3f& point : cloud.points) point.z() = 0.5f;
  return cloud;
}

TEST(Gaussians, ADiscHasTheInformationOfTable2) {
  const Cloud cloud = with_gaussians(flat_points(4000, 2));
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    if (cloud.points[i].head<2>().cwiseAbs().maxCoeff() > 0.7f) continue;
    const Mat3d information = cloud.gaussians[i].information.cast<double>();
    const Eigen::SelfAdjointEigenSolver<Mat3d> eigen(information);
    const Vec3d values = eigen.eigenvalues();
    EXPECT_NEAR(std::abs(eigen.eigenvectors().col(2).z()), 1.0, 1e-5) << i;
    EXPECT_NEAR(values[2] * kLeastVariance / values[0], 1.0, 1e-3) << i;  // the floor, by the largest variance
    EXPECT_NEAR(values[0], 1.0, 0.35) << i;                               // 90 points
    EXPECT_NEAR(values[1], 1.0, 0.5) << i;
  }
}

TEST(Gaussians, FewOrEqualPointsHaveNone) {
  Cloud few;
  for (int i = 0; i < 7; ++i)
    few.points.emplace_back(0.01f * static_cast<float>(i * i), 0.01f * static_cast<float>(i), 0);
  Cloud equal;
  equal.points.assign(100, Vec3f(1.0f, 2.0f, 3.0f));
  for (const Cloud& cloud : {few, equal})
    for (const PointGaussian& gaussian : with_gaussians(cloud).gaussians) {
      EXPECT_TRUE(gaussian.information.isZero(0.0f));
      EXPECT_TRUE(gaussian.mean.allFinite());
    }
  EXPECT_TRUE(with_gaussians(Cloud{}).gaussians.empty());
}

TEST(Gaussians, MoveWithTheCloudAndDoNotDependOnTheUnitOfLength) {
  const Cloud cloud = testing::random_points(800, 1.0, 3), expected = with_gaussians(cloud);
  std::mt19937 generator(3);
  const Rigid3 motion = testing::random_motion(generator, 2.0, 0.0);
  const Cloud moved = with_gaussians(transform(cloud, motion)), also_moved = transform(expected, motion);
  Cloud large = cloud;
  for (Vec3f& point : large.points) point *= 64.0f;
  large = with_gaussians(large, 64.0 * kGaussianRadius);
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    if (expected.gaussians[i].information.isZero(0.0f)) continue;
    EXPECT_LT((moved.gaussians[i].mean - also_moved.gaussians[i].mean).norm(), 1e-5f) << i;
    EXPECT_LT(relative_difference(moved.gaussians[i].information, also_moved.gaussians[i].information), 1e-2) << i;
    EXPECT_LT(relative_difference(large.gaussians[i].information, expected.gaussians[i].information), 1e-5) << i;
  }
}

TEST(Gaussians, SameBitsForAnyNumberOfThreads) {
  const Pinhole camera = testing::kinect_like_camera(80);
  const OrganizedCloud seen = unproject(testing::render(testing::room(), camera).depth, camera);
  const auto in_windows = [&](int num_threads) {
    Cloud cloud = seen.cloud;
    WindowOptions window;
    window.radius = 0.1;
    estimate_gaussians(cloud, WindowNeighbourhood(cloud, seen.index, window, num_threads), 0.1, num_threads);
    return cloud.gaussians;
  };
  const auto expected = in_windows(1);
  for (int num_threads : {2, 3, 8}) {
    const auto gaussians = in_windows(num_threads);
    for (std::size_t i = 0; i < gaussians.size(); ++i) {
      EXPECT_EQ(gaussians[i].mean, expected[i].mean);
      EXPECT_EQ(gaussians[i].information, expected[i].information);
    }
  }
}

TEST(Gaussians, BadRadiusIsRefused) {
  Cloud cloud = testing::random_points(10, 1.0, 4);
  const BallNeighbourhood neighbourhood(cloud, {kGaussianRadius, 0, 0.0}, 1);
  for (double radius : {0.0, -1.0, std::nan("")})
    EXPECT_THROW(estimate_gaussians(cloud, neighbourhood, radius, 1), std::invalid_argument);
}

}  // namespace
}  // namespace augicp
