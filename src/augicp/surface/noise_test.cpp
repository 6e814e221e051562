// SPDX-License-Identifier: MIT
#include "augicp/surface/noise.h"

#include <gtest/gtest.h>

#include <random>

#include "augicp/experiment/random.h"
#include "augicp/registration/registration.h"
#include "augicp/testing/rendering.h"
#include "augicp/testing/scenes.h"

namespace augicp {
namespace {

// A square metre of a plane, `sigma` thick along its normal.
Cloud noisy_plane(std::size_t count, double sigma, unsigned seed) {
  std::mt19937 generator(seed);
  Cloud cloud;
  for (std::size_t i = 0; i < count; ++i) {
    const double x = uniform(generator, -0.5, 0.5), y = uniform(generator, -0.5, 0.5);
    cloud.points.push_back(Vec3d(x, y, sigma * gaussian(generator)).cast<float>());
  }
  return cloud;
}

TEST(ScanNoise, OfAPlaneIsItsThickness) {
  for (const double sigma : {0.001, 0.003, 0.01})
    EXPECT_NEAR(measured_noise(noisy_plane(20000, sigma, 3), 0.05, 1).range_sigma(1.0), sigma, 0.05 * sigma) << sigma;
}

TEST(ScanNoise, OfAnExactPlaneIsZero) {
  const ScanNoise noise = measured_noise(noisy_plane(5000, 0.0, 1), 0.05, 1);
  EXPECT_GT(noise.num_measured, 1000u);
  EXPECT_LT(noise.range_sigma(3.0), 1e-6);
  EXPECT_LT(noise.direction, 1e-6);
}

// The unit does not matter: lengths scale with the cloud, directions do not.
TEST(ScanNoise, ScalesWithTheCloud) {
  Cloud cloud = noisy_plane(5000, 0.004, 1);
  const ScanNoise small = measured_noise(cloud, 0.08, 1);
  for (Vec3f& point : cloud.points) point *= 1000.0f;
  const ScanNoise large = measured_noise(cloud, 80.0, 1);
  EXPECT_NEAR(large.constant, 1000.0 * small.constant, 1e-3 * large.constant);
  EXPECT_NEAR(large.direction, small.direction, 1e-3 * small.direction);
}

// What is predicted of a normal is how far normals of planes drawn anew differ from the true one.
TEST(ScanNoise, PredictsTheSpreadOfNormals) {
  constexpr double kRadius = 0.1;
  double sum_sq = 0.0, count = 0.0;
  for (unsigned seed = 1; seed <= 200; ++seed) {
    const Cloud plane = noisy_plane(2000, 0.005, seed);
    Gaussian ball;
    for (const Vec3f& point : plane.points) {
      if (point.norm() >= kRadius) continue;
      ball.count += 1.0;
      ball.covariance += point.cast<double>() * point.cast<double>().transpose();
      ball.mean += point.cast<double>();
    }
    ball.mean /= ball.count;
    const Mat3d covariance = ball.covariance / ball.count - ball.mean * ball.mean.transpose();
    const Vec3d normal = eigen_of_symmetric(covariance).vectors.col(0);
    sum_sq += normal.head<2>().squaredNorm();
    count += 2.0;
  }
  const double seen = std::sqrt(sum_sq / count);
  EXPECT_NEAR(measured_noise(noisy_plane(2000, 0.005, 1), kRadius, 1).direction, seen, 0.2 * seen);
}

// Noise that grows with the depth squared is told from noise that does not.
TEST(ScanNoise, OfADepthCameraGrowsWithDepth) {
  const testing::Scene room = testing::room(3);
  const Pinhole camera = testing::kinect_like_camera(320);
  DepthImage image = testing::render(room, camera).depth;
  testing::add_depth_noise(image, testing::kKinectSigmaAt1m, 5);
  const ScanNoise noise = measured_noise(scan_of(image, camera).cloud, 0.08, 1);
  for (const double range : {1.5, 2.5, 3.5}) {
    const double expected = testing::kKinectSigmaAt1m * range * range;
    EXPECT_NEAR(noise.range_sigma(range), expected, 0.4 * expected) << range;
  }
}

TEST(ScanNoise, OfTooFewPointsIsNotMeasured) {
  for (const std::size_t count : {0u, 1u, 10u})
    EXPECT_EQ(measured_noise(noisy_plane(count, 0.1, 1), 0.1, 1).num_measured, 0u);
  EXPECT_THROW(measured_noise(Cloud{}, 0.0, 1), std::invalid_argument);
}

TEST(ScanNoise, HasTheSameBitsOnAnyNumberOfThreads) {
  const Cloud cloud = noisy_plane(5000, 0.002, 1);
  const ScanNoise one = measured_noise(cloud, 0.05, 1), four = measured_noise(cloud, 0.05, 4);
  EXPECT_EQ(one.constant, four.constant);
  EXPECT_EQ(one.direction, four.direction);
}

}  // namespace
}  // namespace augicp
