// SPDX-License-Identifier: MIT
#pragma once

#include "augicp/surface/window_neighbourhood.h"

namespace augicp {

// The integral-image window of the authors' software, for comparison: all points in a square of pixels with the area of
// the ball's disc, at any depth. It spans depth discontinuities, and on slanted surfaces it is no ball.
class SquareNeighbourhood : public Neighbourhood {
 public:
  // REQUIRES: the index image is the cloud's own. focal_length in pixels. Only the ball's size of the options is used.
  SquareNeighbourhood(const Cloud& cloud, const IndexImage& index, const WindowOptions& options, double focal_length);
  Channels sum(const Channels& values, int num_threads) const override;

 private:
  IndexImage index_;
  std::vector<std::int32_t> half_side_px_;  // one per point
};

}  // namespace augicp
