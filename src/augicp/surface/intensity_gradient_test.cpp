// SPDX-License-Identifier: MIT
#include "augicp/surface/intensity_gradient.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "augicp/cloud/voxel_grid.h"
#include "augicp/testing/matchers.h"
#include "augicp/testing/poses.h"

namespace augicp {
namespace {

constexpr double kGradientRadius = 0.1;

// Random points of a square metre of the plane x = (a, b, 0), moved, with a brightness of (a, b).
template <typename Brightness>
Cloud plane(const Rigid3& motion, const Brightness& brightness, int count = 2000) {
  std::mt19937 generator(3);
  Cloud cloud;
  for (int i = 0; i < count; ++i) {
    const double a = testing::uniform(generator, 0.0, 1.0), b = testing::uniform(generator, 0.0, 1.0);
    cloud.points.push_back((motion * Vec3d(a, b, 0.0)).cast<float>());
    cloud.intensities.push_back(static_cast<float>(brightness(a, b)));
    cloud.directions.push_back((motion.rotation * Vec3d::UnitZ()).cast<float>());
    cloud.structures.push_back(Structure::Planar);
  }
  return cloud;
}

double ramp(double a, double b) { return 10.0 + 2.0 * a - 3.0 * b; }

TEST(IntensityGradient, IsExactForALinearBrightnessOnAPlane) {
  for (const Rigid3& motion : testing::awkward_poses()) {
    if (motion.translation.norm() > 10.0) continue;  // float is too coarse there: clouds have an origin
    Cloud cloud = plane(motion, ramp);
    estimate_intensity_gradients(cloud, kGradientRadius, 1);
    const Vec3d expected = motion.rotation * Vec3d(2.0, -3.0, 0.0);
    for (const Vec3f& gradient : cloud.intensity_gradients)
      EXPECT_THAT(gradient.cast<double>(), testing::NearVector(expected, 2e-3));
  }
}

TEST(IntensityGradient, LiesInTheTangentPlane) {
  Cloud cloud = plane(Rigid3{}, [](double a, double b) { return std::sin(9.0 * a) * std::cos(7.0 * b); });
  estimate_intensity_gradients(cloud, kGradientRadius, 1);
  for (std::size_t i = 0; i < cloud.size(); ++i)
    EXPECT_NEAR(cloud.intensity_gradients[i].dot(cloud.directions[i]), 0.0, 1e-5);
}

TEST(IntensityGradient, IsZeroWhereNothingIsKnown) {
  Cloud even = plane(Rigid3{}, [](double, double) { return 5.0; });
  estimate_intensity_gradients(even, kGradientRadius, 1);
  for (const Vec3f& gradient : even.intensity_gradients) EXPECT_TRUE(gradient.isZero(0.0f));

  Cloud sparse = plane(Rigid3{}, ramp);
  estimate_intensity_gradients(sparse, 0.01, 1);  // hardly a neighbour
  EXPECT_GT(std::count_if(sparse.intensity_gradients.begin(), sparse.intensity_gradients.end(),
                          [](const Vec3f& gradient) { return gradient.isZero(0.0f); }),
            1900);

  Cloud edges = plane(Rigid3{}, ramp);
  edges.structures[0] = Structure::Edge;
  edges.structures[1] = Structure::None;
  edges.intensities[2] = std::numeric_limits<float>::quiet_NaN();
  estimate_intensity_gradients(edges, kGradientRadius, 1);
  for (std::size_t i : {0u, 1u, 2u}) EXPECT_TRUE(edges.intensity_gradients[i].isZero(0.0f));
  for (std::size_t i = 3; i < edges.size(); ++i) EXPECT_GT(edges.intensity_gradients[i].norm(), 1.0f);
}

TEST(IntensityGradient, IsZeroOnALine) {
  Cloud line = plane(Rigid3{}, ramp, 50);
  for (std::size_t i = 0; i < line.size(); ++i) line.points[i] = Vec3f(0.001f * static_cast<float>(i), 0.0f, 0.0f);
  for (std::size_t i = 0; i < line.size(); ++i) line.intensities[i] = static_cast<float>(i);
  estimate_intensity_gradients(line, kGradientRadius, 1);
  for (const Vec3f& gradient : line.intensity_gradients) EXPECT_TRUE(gradient.isZero(0.0f));
}

// Otherwise the noise of a bare wall would constrain it.
TEST(IntensityGradient, NoiseIsHardlyEverTakenForTexture) {
  std::mt19937 generator(8);
  std::normal_distribution<double> noise(0.0, 1.0);
  Cloud cloud = plane(Rigid3{}, [&](double, double) { return noise(generator); });
  estimate_intensity_gradients(cloud, kGradientRadius, 1);
  EXPECT_LT(std::count_if(cloud.intensity_gradients.begin(), cloud.intensity_gradients.end(),
                          [](const Vec3f& gradient) { return !gradient.isZero(0.0f); }),
            15);  // of 2000
}

TEST(IntensityGradient, OrderOfThePointsAndNumberOfThreadsDoNotMatter) {
  Cloud cloud = plane(Rigid3{}, [](double a, double b) { return std::sin(9.0 * a) * std::cos(7.0 * b); });
  std::vector<std::uint32_t> order(cloud.size());
  for (std::uint32_t i = 0; i < order.size(); ++i) order[i] = i;
  std::shuffle(order.begin(), order.end(), std::mt19937(5));
  Cloud shuffled = select(cloud, order);
  estimate_intensity_gradients(cloud, kGradientRadius, 1);
  for (int num_threads = 1; num_threads <= 8; ++num_threads) {
    Cloud again = cloud;
    estimate_intensity_gradients(again, kGradientRadius, num_threads);
    EXPECT_EQ(again.intensity_gradients, cloud.intensity_gradients);
  }
  estimate_intensity_gradients(shuffled, kGradientRadius, 1);
  for (std::size_t i = 0; i < order.size(); ++i)
    EXPECT_LE((shuffled.intensity_gradients[i] - cloud.intensity_gradients[order[i]]).norm(), 1e-4f);
}

// A grid of 40 x 30 points 5 mm apart, seen one a pixel, with holes.
TEST(IntensityGradient, OnAnImageItIsExactTooAndTheSameOnAnyNumberOfThreads) {
  Cloud cloud;
  IndexImage seen(40, 30);
  for (int v = 0; v < seen.height; ++v)
    for (int u = 0; u < seen.width; ++u) {
      if ((u * 7 + v * 3) % 11 == 0) continue;
      seen.index[static_cast<std::size_t>(v) * seen.width + u] = static_cast<std::int32_t>(cloud.size());
      cloud.points.push_back(Vec3f(0.005f * static_cast<float>(u), 0.005f * static_cast<float>(v), 0.0f));
      cloud.directions.push_back(Vec3f::UnitZ());
      cloud.structures.push_back(Structure::Planar);
      cloud.intensities.push_back(static_cast<float>(ramp(0.005 * u, 0.005 * v)));
    }
  cloud.structures[5] = Structure::Edge;
  estimate_intensity_gradients(cloud, seen, kGradientRadius, 1);
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    const Vec3d expected = i == 5 ? Vec3d::Zero() : Vec3d(2.0, -3.0, 0.0);
    EXPECT_THAT(cloud.intensity_gradients[i].cast<double>(), testing::NearVector(expected, 2e-3));
  }
  Cloud again = cloud;
  estimate_intensity_gradients(again, seen, kGradientRadius, 3);
  EXPECT_EQ(again.intensity_gradients, cloud.intensity_gradients);
  again.directions.clear();
  EXPECT_THROW(estimate_intensity_gradients(again, seen, kGradientRadius, 1), std::invalid_argument);
}

TEST(IntensityGradient, BadInputIsRefused) {
  Cloud cloud = plane(Rigid3{}, ramp, 20);
  EXPECT_THROW(estimate_intensity_gradients(cloud, 0.0, 1), std::invalid_argument);
  cloud.intensities.clear();
  EXPECT_THROW(estimate_intensity_gradients(cloud, kGradientRadius, 1), std::invalid_argument);
  Cloud empty;
  estimate_intensity_gradients(empty, kGradientRadius, 1);
  EXPECT_TRUE(empty.intensity_gradients.empty());
}

}  // namespace
}  // namespace augicp
