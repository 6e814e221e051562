// SPDX-License-Identifier: MIT
#include "augicp/sensor/projection.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "augicp/sensor/depth_image.h"
#include "augicp/testing/poses.h"

namespace augicp {
namespace {

constexpr Pinhole kCentredCamera{50.0, 60.0, 31.5, 23.5};

Cloud random_points(int count, unsigned seed) {
  std::mt19937 generator(seed);
  Cloud cloud;
  for (int i = 0; i < count; ++i) {
    const double x = testing::uniform(generator, -2, 2), y = testing::uniform(generator, -2, 2);
    cloud.points.push_back(Vec3d(x, y, testing::uniform(generator, -1, 3)).cast<float>());
  }
  return cloud;
}

// One pixel after the other, in the plainest way.
IndexImage project_slowly(const Cloud& cloud, const Rigid3& camera_from_points, int width, int height) {
  IndexImage seen(width, height);
  std::vector<double> nearest(seen.index.size(), INFINITY);
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    const Vec3d q = camera_from_points * cloud.points[i].cast<double>();
    if (q.z() <= 0.0) continue;
    const double u = std::floor(kCentredCamera.fx * q.x() / q.z() + kCentredCamera.cx + 0.5);
    const double v = std::floor(kCentredCamera.fy * q.y() / q.z() + kCentredCamera.cy + 0.5);
    if (u < 0 || v < 0 || u >= width || v >= height) continue;
    const std::size_t pixel = static_cast<std::size_t>(v) * width + static_cast<std::size_t>(u);
    if (q.z() >= nearest[pixel]) continue;
    nearest[pixel] = q.z();
    seen.index[pixel] = static_cast<std::int32_t>(i);
  }
  return seen;
}

TEST(Projection, AgreesWithTheSlowWay) {
  std::mt19937 generator(4);
  for (unsigned seed = 0; seed < 5; ++seed) {
    const Cloud cloud = random_points(6000, seed);
    const Rigid3 pose = testing::random_motion(generator, 0.5, 0.3);
    EXPECT_EQ(project(cloud, pose, kCentredCamera, 64, 48).index, project_slowly(cloud, pose, 64, 48).index);
  }
}

TEST(Projection, SameForAnyNumberOfThreads) {
  const Cloud cloud = random_points(50000, 9);
  const IndexImage expected = project(cloud, Rigid3{}, kCentredCamera, 64, 48, 1);
  for (int num_threads = 2; num_threads <= 8; ++num_threads)
    EXPECT_EQ(project(cloud, Rigid3{}, kCentredCamera, 64, 48, num_threads).index, expected.index);
}

TEST(Projection, OfWhatACameraSawIsTheImageAgain) {
  DepthImage image{64, 48, std::vector<float>(64 * 48)};
  std::mt19937 generator(2);
  for (float& z : image.depth) z = static_cast<float>(testing::uniform(generator, 0.5, 4.0));
  const OrganizedCloud seen = unproject(image, kCentredCamera);
  EXPECT_EQ(project(seen.cloud, Rigid3{}, kCentredCamera, 64, 48).index, seen.index.index);
}

TEST(Projection, LowestIndexWinsAmongEquals) {
  Cloud cloud;
  cloud.points.assign(10000, Vec3f(0.0f, 0.0f, 1.0f));
  const IndexImage seen = project(cloud, Rigid3{}, kCentredCamera, 64, 48, 4);
  EXPECT_EQ(seen.at(32, 24), 0);
}

TEST(Projection, NothingInFrontGivesAnEmptyImage) {
  Cloud cloud;
  cloud.points = {{0.0f, 0.0f, -1.0f}, {0.0f, 0.0f, 0.0f}, {1e30f, 0.0f, 1e-30f}};
  EXPECT_EQ(project(cloud, Rigid3{}, kCentredCamera, 4, 4).index, std::vector<std::int32_t>(16, IndexImage::kNone));
  EXPECT_TRUE(project(Cloud{}, Rigid3{}, kCentredCamera, 0, 0).index.empty());
}

}  // namespace
}  // namespace augicp
