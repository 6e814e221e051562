// SPDX-License-Identifier: MIT
#include "augicp/surface/window_neighbourhood.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <utility>

#include "augicp/surface/estimate_surface.h"
#include "augicp/testing/poses.h"
#include "augicp/testing/rendering.h"
#include "augicp/testing/scenes.h"

namespace augicp {
namespace {

using namespace augicp::testing;

WindowOptions windows_of_radius(double radius) {
  WindowOptions options;
  options.radius = radius;
  return options;
}

// A noisy image in which every 13th reading or so is missing.
OrganizedCloud seen_with_holes(const Scene& scene, int width, double sigma_at_1m = kKinectSigmaAt1m) {
  Rendering seen = render(scene, kinect_like_camera(width));
  add_depth_noise(seen.depth, sigma_at_1m, 2);
  std::mt19937 generator(3);
  for (float& depth : seen.depth.depth)
    if (uniform(generator, 0.0, 1.0) < 1.0 / 13.0) depth = std::nanf("");
  return unproject(seen.depth, seen.camera);
}

Channels random_channels(std::size_t count) {
  std::mt19937 generator(4);
  Channels values(2, static_cast<Eigen::Index>(count));
  for (Eigen::Index i = 0; i < values.size(); ++i) values(i) = uniform(generator, 0.5, 1.5);
  return values;
}

// The documented region: from the pixel along its column, and from each point there along the row, as far as the arms.
Eigen::ArrayXd sum_over_arms(const IndexImage& index, const std::vector<Arms>& arms, const Channels& values, int u,
                             int v) {
  Eigen::ArrayXd sum = Eigen::ArrayXd::Zero(values.rows());
  const Arms& own = arms[index.at(u, v)];
  for (int y = v - own.up; y <= v + own.down; ++y) {
    const std::int32_t row_centre = index.at(u, y);
    if (row_centre == IndexImage::kNone) continue;
    for (int x = u - arms[row_centre].left; x <= u + arms[row_centre].right; ++x)
      if (index.at(x, y) != IndexImage::kNone) sum += values.col(index.at(x, y));
  }
  return sum;
}

TEST(WindowNeighbourhood, SumsExactlyOverItsArms) {
  for (const Scene& scene : {box_on_table(), wire(), depth_step()}) {
    const OrganizedCloud seen = seen_with_holes(scene, 160);
    const WindowNeighbourhood windows(seen.cloud, seen.index, windows_of_radius(0.05), 0);
    const Channels values = random_channels(seen.cloud.size());
    const Channels sums = windows.sum(values, 0);
    for (int v = 0; v < seen.index.height; ++v) {
      for (int u = 0; u < seen.index.width; ++u) {
        if (seen.index.at(u, v) == IndexImage::kNone) continue;
        const Eigen::ArrayXd expected = sum_over_arms(seen.index, windows.arms(), values, u, v);
        ASSERT_LE(((sums.col(seen.index.at(u, v)) - expected) / expected).abs().maxCoeff(), 1e-9) << u << ' ' << v;
      }
    }
  }
}

struct Agreement {
  double normals = 0.0;    // share of points planar by both whose normals differ by less than max_angle_deg
  double structure = 0.0;  // share of points of the same structure
};

Agreement agreement(const Cloud& a, const Cloud& b, double max_angle_deg) {
  const double min_cosine = std::cos(max_angle_deg * std::numbers::pi / 180.0);
  int num_planar = 0, num_near = 0, num_same = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    num_same += a.structures[i] == b.structures[i];
    if (a.structures[i] != Structure::Planar || b.structures[i] != Structure::Planar) continue;
    ++num_planar;
    num_near += static_cast<double>(a.directions[i].dot(b.directions[i])) >= min_cosine;
  }
  return {static_cast<double>(num_near) / num_planar, static_cast<double>(num_same) / static_cast<double>(a.size())};
}

// The fast window is a square of the ball's area on each surface. Without noise both agree except at the rims of edges.
// With noise, and some 60 points in a ball, the normals of different samples of one plane differ by a degree or two.
TEST(WindowNeighbourhood, AgreesWithTheExactBall) {
  for (const auto& [sigma_at_1m, max_angle_deg] : {std::pair{0.0, 1.0}, {kKinectSigmaAt1m, 5.0}}) {
    for (const Scene& scene : {box_on_table(), depth_step()}) {
      OrganizedCloud fast = seen_with_holes(scene, 160, sigma_at_1m), exact = fast;
      const WindowOptions options = windows_of_radius(0.05);
      estimate_surface(fast.cloud, WindowNeighbourhood(fast.cloud, fast.index, options, 0), {}, 0);
      estimate_surface(exact.cloud, ExactWindowNeighbourhood(exact.cloud, exact.index, options, 0), {}, 0);
      const Agreement found = agreement(fast.cloud, exact.cloud, max_angle_deg);
      EXPECT_GE(found.normals, 0.98) << sigma_at_1m;
      EXPECT_GE(found.structure, 0.97) << sigma_at_1m;
    }
  }
}

TEST(WindowNeighbourhood, HolesDoNotBreakAWindow) {
  const Rendering seen = render(single_plane(), kinect_like_camera(80));
  DepthImage with_holes = seen.depth;
  for (int k = 0; k < with_holes.width; k += 4)
    for (int v = 0; v < with_holes.height; ++v)
      with_holes.depth[static_cast<std::size_t>(v) * with_holes.width + k] = std::nanf("");
  const OrganizedCloud whole = unproject(seen.depth, seen.camera), part = unproject(with_holes, seen.camera);
  const auto count_at = [](const OrganizedCloud& image, int u, int v) {
    const Channels ones = Channels::Ones(1, static_cast<Eigen::Index>(image.cloud.size()));
    return WindowNeighbourhood(image.cloud, image.index, windows_of_radius(0.3), 0).sum(ones, 0)(image.index.at(u, v));
  };
  EXPECT_NEAR(count_at(part, 41, 30) / count_at(whole, 41, 30), 0.75, 0.06);
}

TEST(WindowNeighbourhood, EmptyImageAndSinglePixel) {
  const OrganizedCloud nothing;
  EXPECT_EQ(WindowNeighbourhood(nothing.cloud, nothing.index, windows_of_radius(0.1), 0).sum(Channels(2, 0), 0).cols(),
            0);
  const OrganizedCloud pixel = unproject({1, 1, {2.0f}}, {500.0, 500.0, 0.0, 0.0, 1, 1});
  EXPECT_EQ(WindowNeighbourhood(pixel.cloud, pixel.index, windows_of_radius(0.1), 0).sum(Channels::Ones(1, 1), 0)(0),
            1.0);
  EXPECT_EQ(
      ExactWindowNeighbourhood(pixel.cloud, pixel.index, windows_of_radius(0.1), 0).sum(Channels::Ones(1, 1), 0)(0),
      1.0);
}

TEST(WindowNeighbourhood, RefusesBadOptions) {
  const OrganizedCloud pixel = unproject({1, 1, {2.0f}}, {500.0, 500.0, 0.0, 0.0, 1, 1});
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const WindowOptions& options :
       {WindowOptions{}, WindowOptions{0.0, 0.0, 0.02}, WindowOptions{-1.0, 0.0, 0.02}, WindowOptions{nan, 0.0, 0.02},
        WindowOptions{0.1, -1.0, 0.02}, WindowOptions{0.1, nan, 0.02}, WindowOptions{0.1, 0.0, 0.0}}) {
    EXPECT_THROW(WindowNeighbourhood(pixel.cloud, pixel.index, options, 0), std::invalid_argument);
    EXPECT_THROW(ExactWindowNeighbourhood(pixel.cloud, pixel.index, options, 0), std::invalid_argument);
  }
}

TEST(WindowNeighbourhood, ThreadsDoNotChangeTheBits) {
  const OrganizedCloud seen = seen_with_holes(box_on_table(), 80);
  const Channels values = random_channels(seen.cloud.size());
  const Channels fast = WindowNeighbourhood(seen.cloud, seen.index, windows_of_radius(0.05), 1).sum(values, 1);
  const Channels exact = ExactWindowNeighbourhood(seen.cloud, seen.index, windows_of_radius(0.05), 1).sum(values, 1);
  for (int n : {2, 3, 8}) {
    EXPECT_TRUE((WindowNeighbourhood(seen.cloud, seen.index, windows_of_radius(0.05), n).sum(values, n) == fast).all());
    EXPECT_TRUE(
        (ExactWindowNeighbourhood(seen.cloud, seen.index, windows_of_radius(0.05), n).sum(values, n) == exact).all());
  }
}

// On a wall nothing is cut off: the neighbours are all points of the ball, and no others.
TEST(WindowNeighbourhood, TheExactOneIsTheBallWhereNothingIsCutOff) {
  const OrganizedCloud wall = unproject({40, 30, std::vector<float>(40 * 30, 2.0f)}, {36.0, 36.0, 19.5, 14.5, 40, 30});
  const double radius = 0.3;
  const auto size = static_cast<Eigen::Index>(wall.cloud.size());
  const Channels found =
      ExactWindowNeighbourhood(wall.cloud, wall.index, windows_of_radius(radius), 1).sum(Channels::Ones(1, size), 1);
  for (Eigen::Index i = 0; i < size; ++i) {
    const auto is_near = [&](const Vec3f& point) {
      return static_cast<double>((point - wall.cloud.points[i]).norm()) <= radius;
    };
    EXPECT_EQ(found(0, i),
              static_cast<double>(std::count_if(wall.cloud.points.begin(), wall.cloud.points.end(), is_near)))
        << i;
  }
}

}  // namespace
}  // namespace augicp
