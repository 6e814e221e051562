// SPDX-License-Identifier: MIT
// The fast way through an image against the plain one: the same windows in estimate_surface().
#include "augicp/surface/window_surface.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "augicp/testing/poses.h"
#include "augicp/testing/rendering.h"
#include "augicp/testing/scenes.h"

namespace augicp {
namespace {

using namespace augicp::testing;

WindowOptions surface_options(double radius) {
  WindowOptions options;
  options.radius = radius;
  return options;
}

OrganizedCloud seen_in(const Scene& scene, int width, double sigma_at_1m, double share_of_holes, double scale = 1.0) {
  Rendering seen = render(scene, kinect_like_camera(width));
  add_depth_noise(seen.depth, sigma_at_1m, 2);
  std::mt19937 generator(3);
  for (float& depth : seen.depth.depth)
    depth = uniform(generator, 0.0, 1.0) < share_of_holes ? std::nanf("") : static_cast<float>(scale) * depth;
  return unproject(seen.depth, seen.camera);
}

Cloud fast(const OrganizedCloud& seen, double radius, const SurfaceOptions& options = {}, int num_threads = 0) {
  Cloud cloud = seen.cloud;
  estimate_surface(cloud, seen.index, surface_options(radius), options, num_threads);
  return cloud;
}

Cloud plain(const OrganizedCloud& seen, double radius, const SurfaceOptions& options = {}) {
  Cloud cloud = seen.cloud;
  estimate_surface(cloud, WindowNeighbourhood(seen.cloud, seen.index, surface_options(radius), 0), options, 0);
  return cloud;
}

struct Differences {
  std::size_t structures = 0;  // points of another structure
  std::size_t directions = 0;  // points with the same structure but another direction
};

Differences differences(const Cloud& a, const Cloud& b, double max_angle_deg) {
  const double max_sine = std::sin(max_angle_deg * std::numbers::pi / 180.0);
  Differences found;
  for (std::size_t i = 0; i < a.size(); ++i) {
    const Vec3d x = a.directions[i].cast<double>(), y = b.directions[i].cast<double>();
    const bool with_sign = a.structures[i] == Structure::Planar && a.viewpoint;
    found.structures += a.structures[i] != b.structures[i];
    if (a.structures[i] == b.structures[i])
      found.directions += x.cross(y).norm() > max_sine || (with_sign && x.dot(y) <= 0.0);
  }
  return found;
}

TEST(WindowSurface, EqualsThePlainWayButForRounding) {
  for (const double sigma_at_1m : {0.0, kKinectSigmaAt1m, 0.01})
    for (const Scene& scene : {box_on_table(), wire(), depth_step(), room_corner(), sphere_scene(), cylinder_scene()}) {
      const OrganizedCloud seen = seen_in(scene, 240, sigma_at_1m, 0.05);
      for (const Classifier classifier : {Classifier::Normals, Classifier::Eigenvalues}) {
        SurfaceOptions options;
        options.classifier = classifier;
        const Differences found = differences(fast(seen, 0.05, options), plain(seen, 0.05, options), 0.1);
        const double count = static_cast<double>(seen.cloud.size());
        EXPECT_LE(static_cast<double>(found.structures), 5e-4 * count);
        // On steep surfaces the points are almost on a line, and float makes the normal less accurate.
        EXPECT_LE(static_cast<double>(found.directions), 2e-3 * count);
      }
    }
}

// Squares of 100 m^2 are summed, and a surface differs from noise by millimetres.
TEST(WindowSurface, SumsStayAccurateFarAway) {
  for (const double scale : {0.2, 5.0, 10.0}) {
    const OrganizedCloud seen = seen_in(single_plane(), 320, 0.0, 0.1, scale);
    const Cloud found = fast(seen, 0.05 * scale), expected = plain(seen, 0.05 * scale);
    const Differences apart = differences(found, expected, 0.01);
    EXPECT_EQ(apart.structures, 0u) << scale;
    EXPECT_EQ(apart.directions, 0u) << scale;
  }
}

TEST(WindowSurface, EqualsThePlainWayAtBordersAndInSmallImages) {
  for (const int width : {1, 2, 7, 31, 32, 33, 65}) {
    const OrganizedCloud seen = seen_in(box_on_table(), width, kKinectSigmaAt1m, 0.0);
    const Differences found = differences(fast(seen, 0.3), plain(seen, 0.3), 0.1);
    EXPECT_LE(found.structures + found.directions, 1u) << width;
  }
}

// Sums along rows run strip by strip of columns: with blank strips, blank rows of a strip, and both beside seen pixels.
TEST(WindowSurface, EqualsThePlainWayAroundBlankPatches) {
  Rendering seen = render(box_on_table(), kinect_like_camera(240));
  add_depth_noise(seen.depth, kKinectSigmaAt1m, 2);
  const auto blank = [&](int u0, int u1, int v0, int v1) {
    for (int v = v0; v < v1; ++v)
      std::fill_n(seen.depth.depth.begin() + v * seen.depth.width + u0, u1 - u0, std::nanf(""));
  };
  blank(20, 110, 30, 90);
  blank(128, 160, 0, seen.depth.height);
  blank(200, 201, 0, seen.depth.height);
  blank(0, seen.depth.width, 140, 150);
  const OrganizedCloud image = unproject(seen.depth, seen.camera);
  const Differences found = differences(fast(image, 0.05), plain(image, 0.05), 0.1);
  EXPECT_LE(static_cast<double>(found.structures + found.directions), 1e-3 * static_cast<double>(image.cloud.size()));
}

TEST(WindowSurface, KnowsNoSideWithoutAViewpoint) {
  OrganizedCloud seen = seen_in(wire(), 160, kKinectSigmaAt1m, 0.0);
  seen.cloud.viewpoint.reset();
  const Differences found = differences(fast(seen, 0.05), plain(seen, 0.05), 0.1);
  EXPECT_LE(static_cast<double>(found.structures + found.directions), 1e-3 * static_cast<double>(seen.cloud.size()));
}

TEST(WindowSurface, EmptyImagesAndSinglePixels) {
  OrganizedCloud nothing;
  EXPECT_TRUE(fast(nothing, 0.1).directions.empty());
  const float nan = std::nanf("");
  EXPECT_TRUE(fast(unproject({2, 2, {nan, nan, nan, nan}}, {500.0, 500.0, 0.0, 0.0, 2, 2}), 0.1).structures.empty());
  const Cloud pixel = fast(unproject({1, 1, {2.0f}}, {500.0, 500.0, 0.0, 0.0, 1, 1}), 0.1);
  EXPECT_EQ(pixel.structures, std::vector{Structure::None});
  EXPECT_EQ(pixel.directions[0], Vec3f(Vec3f::Zero()));
}

TEST(WindowSurface, PointsWithoutAPixelHaveNoStructure) {
  OrganizedCloud seen = seen_in(single_plane(), 40, 0.0, 0.0);
  seen.index.index[0] = IndexImage::kNone;
  seen.cloud.directions.assign(seen.cloud.size(), Vec3f::UnitX());
  seen.cloud.structures.assign(seen.cloud.size(), Structure::Edge);
  const Cloud found = fast(seen, 0.3);
  EXPECT_EQ(found.structures[0], Structure::None);
  EXPECT_EQ(found.directions[0], Vec3f(Vec3f::Zero()));
  EXPECT_EQ(found.structures[1], Structure::Planar);
}

TEST(WindowSurface, RefusesBadOptions) {
  OrganizedCloud nothing;
  EXPECT_THROW(estimate_surface(nothing.cloud, nothing.index, surface_options(0.0), {}, 1), std::invalid_argument);
}

TEST(WindowSurface, ThreadsDoNotChangeTheBits) {
  const OrganizedCloud seen = seen_in(box_on_table(), 160, kKinectSigmaAt1m, 0.05);
  const Cloud expected = fast(seen, 0.05, {}, 1);
  for (const int num_threads : {2, 3, 8}) {
    const Cloud found = fast(seen, 0.05, {}, num_threads);
    EXPECT_EQ(found.directions, expected.directions);
    EXPECT_EQ(found.structures, expected.structures);
  }
}

}  // namespace
}  // namespace augicp
