// SPDX-License-Identifier: MIT
#include "augicp/testing/rendering.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <span>

#include "augicp/testing/matchers.h"
#include "augicp/testing/rolling_camera.h"
#include "augicp/testing/scenes.h"

namespace augicp::testing {
namespace {

DepthImage constant_depth(float depth) { return {200, 200, std::vector<float>(200 * 200, depth)}; }

TEST(Rendering, PlaneHasItsExactDepthEverywhere) {
  const Scene scene = single_plane();
  const Plane& plane = std::get<Plane>(scene.surfaces[0]);
  const Rendering seen = render(scene, kinect_like_camera(80));
  const OrganizedCloud organized = unproject(seen.depth, seen.camera);
  ASSERT_EQ(organized.cloud.size(), 80u * 60u);
  for (const Vec3f& point : organized.cloud.points) {
    const Vec3d in_world = scene.world_from_camera * point.cast<double>();
    EXPECT_NEAR(plane.normal.dot(in_world - plane.point), 0.0, 1e-6);
  }
}

// The exact normal is orthogonal to the line between neighbouring pixels of the same surface, up to curvature.
TEST(Rendering, NormalsAgreeWithFiniteDifferencesOfDepth) {
  for (const Scene& scene : {box_on_table(), room_corner(), sphere_scene(), cylinder_scene()}) {
    const Rendering seen = render(scene, kinect_like_camera(320));
    const OrganizedCloud organized = unproject(seen.depth, seen.camera);
    int num_checked = 0;
    for (int v = 1; v + 1 < seen.depth.height; v += 3) {
      for (int u = 1; u + 1 < seen.depth.width; u += 3) {
        const int pixel = v * seen.depth.width + u;
        const int left = pixel - 1, right = pixel + 1, up = pixel - seen.depth.width, down = pixel + seen.depth.width;
        std::set<int> surfaces{seen.surface[left], seen.surface[right], seen.surface[up], seen.surface[down]};
        // Near a contour the surface curves away too fast for differences over a pixel.
        if (surfaces != std::set<int>{seen.surface[pixel]} || *surfaces.begin() == Rendering::kNothing) continue;
        const auto point = [&](int at) { return organized.cloud.points[organized.index.index[at]]; };
        const Vec3f expected = (point(down) - point(up)).cross(point(right) - point(left)).normalized();
        if (std::abs(expected.dot(point(pixel).normalized())) < 0.3f) continue;
        EXPECT_NEAR(std::abs(expected.dot(seen.normal[pixel])), 1.0, 2e-3) << "pixel " << u << ", " << v;
        EXPECT_LT(seen.normal[pixel].dot(point(pixel)), 0.0f);
        ++num_checked;
      }
    }
    EXPECT_GT(num_checked, 500);
  }
}

TEST(Rendering, ARowIsThatOfTheImage) {
  const Scene scene = box_on_table();
  const Pinhole camera = kinect_like_camera(80);
  const DepthImage image = render(scene, camera).depth;
  for (int v = 0; v < image.height; ++v)
    EXPECT_THAT(render_row(scene, camera, v, scene.world_from_camera),
                ::testing::Pointwise(::testing::NanSensitiveFloatEq(),
                                     std::span(image.depth).subspan(v * image.width, image.width)));
}

TEST(Rendering, ClosedRoomLeavesNoPixelEmpty) {
  for (unsigned seed = 1; seed <= 3; ++seed) {
    const Rendering seen = render(room(seed), kinect_like_camera(160));
    for (int surface : seen.surface) ASSERT_NE(surface, Rendering::kNothing);
    EXPECT_GE(std::set<int>(seen.surface.begin(), seen.surface.end()).size(), 12u);
  }
}

TEST(Rendering, NothingIsSeenAsNoDepth) {
  const Rendering seen = render(sphere_scene(), kinect_like_camera(80));
  EXPECT_TRUE(std::isnan(seen.depth.at(0, 0)));
  EXPECT_EQ(seen.surface[0], Rendering::kNothing);
  EXPECT_EQ(seen.normal[0], Vec3f(Vec3f::Zero()));
}

TEST(Rendering, WireIsSeenBeforeTheWall) {
  const Rendering seen = render(wire(), kinect_like_camera(320));
  std::vector<int> pixels_of(3, 0);
  for (int surface : seen.surface)
    if (surface != Rendering::kNothing) ++pixels_of[surface];
  EXPECT_GT(pixels_of[1], 240);
  EXPECT_GT(pixels_of[2], 240);
}

TEST(DepthNoise, HasTheStatedSigmaAtEveryDepth) {
  for (float depth : {0.5f, 1.0f, 3.0f}) {
    DepthImage image = constant_depth(depth);
    add_depth_noise(image, kKinectSigmaAt1m, 3);
    double sum = 0.0, sum_of_squares = 0.0;
    for (float noisy : image.depth) {
      sum += noisy - depth;
      sum_of_squares += std::pow(noisy - depth, 2);
    }
    const double count = static_cast<double>(image.depth.size()), sigma = kKinectSigmaAt1m * depth * depth;
    EXPECT_NEAR(sum / count, 0.0, 5.0 * sigma / std::sqrt(count));
    EXPECT_NEAR(std::sqrt(sum_of_squares / count), sigma, 0.02 * sigma);
  }
}

TEST(DepthNoise, KeepsMissingReadingsMissing) {
  DepthImage image = constant_depth(std::nanf(""));
  add_depth_noise(image, kKinectSigmaAt1m, 3);
  quantise_disparity(image);
  for (float depth : image.depth) EXPECT_TRUE(std::isnan(depth));
}

TEST(DepthNoise, QuantisationMovesDepthByAtMostHalfAStep) {
  for (double depth = 0.5; depth < 4.0; depth += 0.013) {
    DepthImage image{1, 1, {static_cast<float>(depth)}};
    quantise_disparity(image);
    // The step itself grows within the step: a twentieth more.
    EXPECT_NEAR(image.depth[0], depth, 0.5 * kKinectStepAt1m * depth * depth * 1.05);
    const float once = image.depth[0];
    quantise_disparity(image);
    EXPECT_FLOAT_EQ(image.depth[0], once);
  }
}

}  // namespace
}  // namespace augicp::testing
