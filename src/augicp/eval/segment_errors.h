// SPDX-License-Identifier: MIT
// KITTI's errors of an odometry, over segments of given lengths (A. Geiger et al., "Are we ready for autonomous
// driving?", CVPR 2012).
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "augicp/geometry/rigid3.h"

namespace augicp {

struct SegmentOptions {
  // Lengths of the true path, metres, each above 0.
  std::vector<double> lengths{100.0, 200.0, 300.0, 400.0, 500.0, 600.0, 700.0, 800.0};

  // A segment of each length begins at every such pose; at least 1.
  std::size_t step = 10;

  // Throws std::invalid_argument naming the first field out of its range.
  void check() const;
};

// Means over segments.
struct SegmentError {
  double length = 0.0;  // metres; 0: over all lengths
  std::size_t num_segments = 0;
  double translation = 0.0;  // part of the length
  double rotation = 0.0;     // radians a metre
};

struct SegmentErrors {
  std::vector<SegmentError> of_length;  // without lengths that no segment reaches
  SegmentError all;
};

// A segment ends at the first pose whose true path from its first pose is longer than the length. Both as
// world_from_sensor, pose by pose. Throws std::invalid_argument if their counts differ.
SegmentErrors segment_errors(std::span<const Rigid3> truth, std::span<const Rigid3> estimate,
                             const SegmentOptions& options = {});

}  // namespace augicp
