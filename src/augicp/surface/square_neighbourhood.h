// SPDX-License-Identifier: MIT
#pragma once

#include "augicp/surface/window_neighbourhood.h"

namespace augicp {

// The integral-image window of the authors' software, for comparisons: all points in a square of pixels as wide as the
// ball's disc has area, whatever their depth. It reaches across depth discontinuities, and on slanted surfaces it is no
// ball.
class SquareNeighbourhood : public Neighbourhood {
 public:
  // The index image must be the cloud's own. focal_length in pixels; of the options only the ball's size counts.
  SquareNeighbourhood(const Cloud& cloud, const IndexImage& index, const WindowOptions& options, double focal_length);
  Channels sum(const Channels& values, int num_threads) const override;

 private:
  IndexImage index_;
  std::vector<std::int32_t> half_side_px_;  // one a point
};

}  // namespace augicp
