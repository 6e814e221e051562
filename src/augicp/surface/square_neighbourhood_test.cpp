// SPDX-License-Identifier: MIT
#include "augicp/surface/square_neighbourhood.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>

#include "augicp/surface/arms.h"
#include "augicp/testing/rendering.h"
#include "augicp/testing/scenes.h"

namespace augicp {
namespace {

TEST(SquareNeighbourhood, CountsThePointsOfItsSquare) {
  const testing::Rendering seen = testing::render(testing::box_on_table(), testing::kinect_like_camera(80));
  const OrganizedCloud image = unproject(seen.depth, seen.camera);
  WindowOptions window;
  window.radius = 0.05;
  const SquareNeighbourhood square(image.cloud, image.index, window, seen.camera.fx);
  const auto count = static_cast<Eigen::Index>(image.cloud.size());
  const Channels counts = square.sum(Channels::Ones(1, count), 1);
  for (int v = 0; v < image.index.height; v += 7)
    for (int u = 0; u < image.index.width; u += 5) {
      const std::int32_t i = image.index.at(u, v);
      if (i == IndexImage::kNone) continue;
      const double side =
          kSquareHalfSide * window.radius * seen.camera.fx / static_cast<double>(image.cloud.points[i].z());
      const int half = std::max(1, static_cast<int>(std::lround(side)));
      int expected = 0;
      for (int y = 0; y < image.index.height; ++y)
        for (int x = 0; x < image.index.width; ++x)
          expected += std::abs(x - u) <= half && std::abs(y - v) <= half && image.index.at(x, y) != IndexImage::kNone;
      EXPECT_EQ(counts(0, i), expected) << "pixel " << u << ", " << v;
    }
}

}  // namespace
}  // namespace augicp
