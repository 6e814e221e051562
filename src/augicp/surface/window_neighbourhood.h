// SPDX-License-Identifier: MIT
// Neighbourhoods on depth images: points that are reached from a pixel without crossing a depth discontinuity.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "augicp/cloud/index_image.h"
#include "augicp/surface/neighbourhood.h"

namespace augicp {

struct WindowOptions {
  double radius = 0.0;  // radius of the ball that the window approximates, metres, above 0

  // The ball grows with depth, to at least this many times the point's depth, because the noise of a depth camera does.
  double radius_per_depth = 0.0;

  // Two neighbouring readings belong to different surfaces if they differ along the optical axis by more than this many
  // times their depth. 0.02 is above a Kinect's quantisation up to 7 m, and below the slope of a surface seen at 85
  // degrees.
  double max_step_per_depth = 0.02;
};

// The reach of a pixel's neighbourhood in its own row and column, in pixels: first left, right, up, down.
struct Arms {
  std::int16_t left = 0, right = 0, up = 0, down = 0;
};

// Fast: a window of 3D size. From every pixel two arms reach along its column, and from each pixel on them two along
// its row, as far as the ball's size on that surface, and never across a discontinuity. Sums over such regions take two
// passes of prefix sums, for any size ("cross-based" regions of stereo matching: Zhang, Lu, Lafruit 2009). The half
// side of the window makes its area that of the ball's disc.
class WindowNeighbourhood : public Neighbourhood {
 public:
  // REQUIRES: the index image is the cloud's own, each point in its pixel, in raster order. Both are read only in the
  // constructor.
  WindowNeighbourhood(const Cloud& cloud, const IndexImage& index, const WindowOptions& options, int num_threads);
  Channels sum(const Channels& values, int num_threads) const override;

  const std::vector<Arms>& arms() const { return arms_; }

 private:
  IndexImage index_;
  std::vector<Arms> arms_;  // one per point
};

// Exact and slow, for tests and comparison: every point of the ball whose column-then-row path from the centre crosses
// no discontinuity.
class ExactWindowNeighbourhood : public Neighbourhood {
 public:
  ExactWindowNeighbourhood(const Cloud& cloud, const IndexImage& index, const WindowOptions& options, int num_threads);
  Channels sum(const Channels& values, int num_threads) const override;

 private:
  std::vector<std::vector<std::uint32_t>> neighbours_;
};

}  // namespace augicp
