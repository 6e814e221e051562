// SPDX-License-Identifier: MIT
// The errors by which LiDAR odometries are compared: KITTI's, over segments of given lengths (A. Geiger et al., "Are we
// ready for autonomous driving?", CVPR 2012), and against motions that are known for some pairs of scans.
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
// world_from_sensor, pose by pose. Throws std::invalid_argument unless there are as many of both.
SegmentErrors segment_errors(std::span<const Rigid3> truth, std::span<const Rigid3> estimate,
                             const SegmentOptions& options = {});

// A motion between two scans that is known from elsewhere.
struct ReferencePair {
  std::size_t first = 0, second = 0;  // places of the poses, from 0
  Rigid3 first_from_second;
};

struct PairError {
  ReferencePair pair;
  double translation = 0.0;  // metres, of the difference of the motions
  double rotation = 0.0;     // radians
  double bias = 0.0;         // metres: how much longer the estimated motion is than the known one
};

// Of the pairs whose poses are there. estimate: as world_from_sensor.
std::vector<PairError> pair_errors(std::span<const Rigid3> estimate, std::span<const ReferencePair> pairs);

}  // namespace augicp
