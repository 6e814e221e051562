// SPDX-License-Identifier: MIT
#include "augicp/surface/window_spans.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>
#include <vector>

#include "augicp/testing/poses.h"
#include "augicp/testing/rendering.h"
#include "augicp/testing/scenes.h"

namespace augicp {
namespace {

using namespace augicp::testing;

OrganizedCloud seen_with_holes(const Scene& scene, double sigma_at_1m) {
  Rendering seen = render(scene, kinect_like_camera(160));
  add_depth_noise(seen.depth, sigma_at_1m, 2);
  std::mt19937 generator(3);
  for (float& depth : seen.depth.depth)
    if (uniform(generator, 0.0, 1.0) < 0.1) depth = std::nanf("");
  return unproject(seen.depth, seen.camera);
}

WindowOptions options_with(double radius, double radius_per_depth) {
  WindowOptions options;
  options.radius = radius;
  options.radius_per_depth = radius_per_depth;
  return options;
}

struct Spans {
  std::vector<Span> in_row, in_column;
};
Spans window_spans(const OrganizedCloud& seen, const WindowOptions& options, int num_threads) {
  const std::vector<Span> before(seen.index.index.size(), Span{3, 5});  // all of it must be overwritten
  Spans spans{before, before};
  find_window_spans(seen.cloud, seen.index, options, num_threads,
                    {seen.index.width, seen.index.height, spans.in_row, spans.in_column});
  return spans;
}

TEST(WindowSpans, AreTheArms) {
  for (const double sigma_at_1m : {0.0, kKinectSigmaAt1m, 0.02})
    for (const Scene& scene : {box_on_table(), wire(), depth_step(), room()})
      for (const WindowOptions& options :
           {options_with(0.05, 0.0), options_with(0.01, 0.04), options_with(10.0, 0.0)}) {
        const OrganizedCloud seen = seen_with_holes(scene, sigma_at_1m);
        const std::vector<Arms> arms = WindowNeighbourhood(seen.cloud, seen.index, options, 0).arms();
        const Spans spans = window_spans(seen, options, 0);
        for (int v = 0, pixel = 0; v < seen.index.height; ++v)
          for (int u = 0; u < seen.index.width; ++u, ++pixel) {
            const Span row = spans.in_row[pixel], column = spans.in_column[pixel];
            if (seen.index.at(u, v) == IndexImage::kNone) {
              ASSERT_TRUE(row.begin == row.end && column.begin == column.end);
              continue;
            }
            const Arms& expected = arms[seen.index.at(u, v)];
            ASSERT_EQ(row.begin, u - expected.left) << u << ' ' << v;
            ASSERT_EQ(row.end, u + expected.right + 1) << u << ' ' << v;
            ASSERT_EQ(column.begin, v - expected.up) << u << ' ' << v;
            ASSERT_EQ(column.end, v + expected.down + 1) << u << ' ' << v;
          }
      }
}

TEST(WindowSpans, ThreadsDoNotChangeThem) {
  const OrganizedCloud seen = seen_with_holes(box_on_table(), kKinectSigmaAt1m);
  const Spans expected = window_spans(seen, options_with(0.05, 0.0), 1);
  const Spans found = window_spans(seen, options_with(0.05, 0.0), 3);
  EXPECT_EQ(found.in_row, expected.in_row);
  EXPECT_EQ(found.in_column, expected.in_column);
}

TEST(WindowSpans, RefuseTooLongSides) {
  EXPECT_THROW(window_spans({{}, IndexImage(65536, 1)}, options_with(0.05, 0.0), 1), std::invalid_argument);
}

}  // namespace
}  // namespace augicp
