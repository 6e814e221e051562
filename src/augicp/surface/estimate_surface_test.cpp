// SPDX-License-Identifier: MIT
#include "augicp/surface/estimate_surface.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <tuple>

#include "augicp/surface/ball_neighbourhood.h"
#include "augicp/surface/window_neighbourhood.h"
#include "augicp/testing/edge_truth.h"
#include "augicp/testing/poses.h"
#include "augicp/testing/rendering.h"
#include "augicp/testing/scenes.h"

namespace augicp {
namespace {

using namespace augicp::testing;

double degrees_between(const Vec3f& a, const Vec3f& b) {
  return std::acos(std::clamp(static_cast<double>(a.dot(b)), -1.0, 1.0)) * 180.0 / std::numbers::pi;
}

Cloud in_balls(Cloud cloud, double radius, int num_threads = 0) {
  estimate_surface(cloud, BallNeighbourhood(cloud, {radius, 0, 0.0}, num_threads), {}, num_threads);
  return cloud;
}

Cloud in_windows(const OrganizedCloud& seen, double radius, const SurfaceOptions& options = {}, int num_threads = 0) {
  Cloud cloud = seen.cloud;
  WindowOptions window;
  window.radius = radius;
  estimate_surface(cloud, WindowNeighbourhood(cloud, seen.index, window, num_threads), options, num_threads);
  return cloud;
}

// Flat, 1 x 1 m, at z = 0, with normal noise in z.
Cloud sheet(int count, double sigma) {
  std::mt19937 generator(7);
  Cloud cloud;
  for (int i = 0; i < count; ++i) {
    const double x = uniform(generator, -0.5, 0.5), y = uniform(generator, -0.5, 0.5);
    cloud.points.push_back(Vec3d(x, y, sigma * gaussian(generator)).cast<float>());
  }
  return cloud;
}

// Two sheets that meet at a right angle along x.
Cloud fold(int count) {
  Cloud cloud = sheet(count, 0.001);
  for (Vec3f& p : cloud.points)
    if (p.y() < 0.0f) p = Vec3f(p.x(), p.z(), -p.y());
  return cloud;
}

// Unit directions for points with a structure, zero for the others; no NaN.
void expect_well_formed(const Cloud& cloud) {
  ASSERT_EQ(cloud.directions.size(), cloud.size());
  ASSERT_EQ(cloud.structures.size(), cloud.size());
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    const float expected = cloud.structures[i] == Structure::None ? 0.0f : 1.0f;
    ASSERT_NEAR(cloud.directions[i].norm(), expected, 1e-5f) << i;
  }
}

// The normal's error is about sigma / (spread sqrt(n)) radians, with n points of standard deviation spread in the ball:
// here n = 157 and spread = 5 cm (at the rim half of both), so 0.18 and 0.9 degrees for 2 and 10 mm.
TEST(EstimateSurface, NormalsOfANoisyPlane) {
  for (const auto& [sigma, max_mean_deg, max_deg] :
       {std::tuple{0.0, 1e-3, 1e-2}, {0.002, 0.4, 2.0}, {0.01, 2.0, 10.0}}) {
    const Cloud cloud = in_balls(sheet(5000, sigma), 0.1);
    double sum_deg = 0.0, worst_deg = 0.0;
    for (std::size_t i = 0; i < cloud.size(); ++i) {
      ASSERT_EQ(cloud.structures[i], Structure::Planar);
      const double error =
          std::acos(std::min(1.0, std::abs(static_cast<double>(cloud.directions[i].z())))) * 180.0 / std::numbers::pi;
      sum_deg += error;
      worst_deg = std::max(worst_deg, error);
    }
    EXPECT_LE(sum_deg / static_cast<double>(cloud.size()), max_mean_deg) << sigma;
    EXPECT_LE(worst_deg, max_deg) << sigma;
  }
}

TEST(EstimateSurface, NormalsOfASphereAreItsRadii) {
  std::mt19937 generator(8);
  Cloud cloud;
  for (int i = 0; i < 5000; ++i) cloud.points.push_back(random_direction(generator).cast<float>());
  const Cloud estimated = in_balls(cloud, 0.2);
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    ASSERT_EQ(estimated.structures[i], Structure::Planar);
    ASSERT_LT(std::acos(std::min(1.0f, std::abs(estimated.directions[i].dot(cloud.points[i])))), 0.05f);
  }
}

TEST(EstimateSurface, LineIsAnEdgeAlongItself) {
  for (const Classifier classifier : {Classifier::Normals, Classifier::Eigenvalues}) {
    std::mt19937 generator(9);
    const Vec3d along = random_direction(generator);
    Cloud cloud;
    for (int i = 0; i < 200; ++i)
      cloud.points.push_back((0.005 * i * along + 0.001 * random_direction(generator)).cast<float>());
    SurfaceOptions options;
    options.classifier = classifier;
    estimate_surface(cloud, BallNeighbourhood(cloud, {0.05, 0, 0.0}, 0), options, 0);
    for (std::size_t i = 0; i < cloud.size(); ++i) {
      ASSERT_EQ(cloud.structures[i], Structure::Edge);
      ASSERT_GT(std::abs(cloud.directions[i].dot(along.cast<float>())), std::cos(0.05f));
    }
  }
}

TEST(EstimateSurface, FoldIsAnEdgeNearItsCreaseOnly) {
  const Cloud cloud = in_balls(fold(8000), 0.1);
  int num_near = 0, num_edge = 0;
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    const float distance = cloud.points[i].tail<2>().norm();
    if (std::abs(cloud.points[i].x()) > 0.4f) continue;  // beside the crease's ends
    if (distance > 0.15f) {
      EXPECT_EQ(cloud.structures[i], Structure::Planar);
    }
    if (distance > 0.1f) continue;
    ++num_near;
    num_edge += cloud.structures[i] == Structure::Edge &&
                std::abs(cloud.directions[i].x()) > std::cos(5.0f * 3.14159f / 180.0f);
  }
  EXPECT_GE(num_edge, 0.9 * num_near);
}

TEST(EstimateSurface, NormalsPointToTheViewpoint) {
  for (const float side : {-1.0f, 1.0f}) {
    Cloud cloud = sheet(1000, 0.001);
    cloud.viewpoint = Vec3f(0.1f, 0.2f, side);
    for (const Vec3f& normal : in_balls(cloud, 0.2).directions) EXPECT_GT(side * normal.z(), 0.9f);
  }
}

TEST(EstimateSurface, TooLittleToGoByIsNone) {
  Cloud few, equal;
  for (int i = 0; i < 7; ++i)
    few.points.emplace_back(0.01f * static_cast<float>(i % 3), 0.01f * static_cast<float>(i / 3), 0.0f);
  equal.points.assign(50, Vec3f(1.0f, 2.0f, 3.0f));
  for (const Cloud& cloud : {Cloud{}, few, equal}) {
    const Cloud estimated = in_balls(cloud, 0.5);
    expect_well_formed(estimated);
    EXPECT_THAT(estimated.structures, ::testing::Each(Structure::None));
  }
}

TEST(EstimateSurface, DirectionsAreUnitOrZeroOnEveryScene) {
  for (const Scene& scene : {box_on_table(), room(), wire(), depth_step(), sphere_scene()}) {
    Rendering seen = render(scene, kinect_like_camera(160));
    add_depth_noise(seen.depth, kKinectSigmaAt1m, 4);
    for (const Classifier classifier : {Classifier::Normals, Classifier::Eigenvalues}) {
      SurfaceOptions options;
      options.classifier = classifier;
      expect_well_formed(in_windows(unproject(seen.depth, seen.camera), 0.05, options));
    }
  }
}

TEST(EstimateSurface, MovesWithTheCloud) {
  const Cloud cloud = fold(3000);
  const Cloud estimated = in_balls(cloud, 0.1);
  std::mt19937 generator(11);
  const Rigid3 b_from_a = random_motion(generator, 1.0, 0.5);
  const Cloud expected = transform(estimated, b_from_a), found = in_balls(transform(cloud, b_from_a), 0.1);
  int num_same = 0;  // rounding the moved points to floats may change a point on a threshold
  for (std::size_t i = 0; i < cloud.size(); ++i)
    num_same +=
        found.structures[i] == expected.structures[i] &&
        std::abs(found.directions[i].dot(expected.directions[i])) > (found.directions[i].isZero() ? -1.0f : 0.9999f);
  EXPECT_GE(num_same, 0.995 * static_cast<double>(cloud.size()));
}

// Two ways to the same neighbourhood, one along pixels and one through space, away from jumps.
TEST(EstimateSurface, WindowsAgreeWithBalls) {
  Rendering seen = render(box_on_table(), kinect_like_camera(240));
  const std::vector<bool> beside = beside_discontinuity(seen, 12, 0.03);
  add_depth_noise(seen.depth, kKinectSigmaAt1m, 5);
  const OrganizedCloud organized = unproject(seen.depth, seen.camera);
  const Cloud windows = in_windows(organized, 0.05), balls = in_balls(organized.cloud, 0.05);
  int num_points = 0, num_same = 0, num_planar = 0, num_near = 0;
  for (std::size_t pixel = 0; pixel < beside.size(); ++pixel) {
    const std::int32_t i = organized.index.index[pixel];
    if (i == IndexImage::kNone || beside[pixel]) continue;
    ++num_points;
    num_same += windows.structures[i] == balls.structures[i];
    if (windows.structures[i] != Structure::Planar || balls.structures[i] != Structure::Planar) continue;
    ++num_planar;
    num_near += degrees_between(windows.directions[i], balls.directions[i]) < 3.0;
  }
  EXPECT_GE(num_same, 0.95 * num_points);
  EXPECT_GE(num_near, 0.98 * num_planar);
}

TEST(EstimateSurface, ThreadsDoNotChangeTheBits) {
  const Rendering seen = render(box_on_table(), kinect_like_camera(80));
  const OrganizedCloud organized = unproject(seen.depth, seen.camera);
  const Cloud windows = in_windows(organized, 0.05, {}, 1), balls = in_balls(organized.cloud, 0.05, 1);
  for (int num_threads : {2, 3, 8}) {
    EXPECT_EQ(in_windows(organized, 0.05, {}, num_threads).directions, windows.directions);
    EXPECT_EQ(in_balls(organized.cloud, 0.05, num_threads).directions, balls.directions);
  }
}

}  // namespace
}  // namespace augicp
