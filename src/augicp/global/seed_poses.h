// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <vector>

#include "augicp/global/consistency.h"

namespace augicp {

// A pose, and how many correspondences support it.
struct SeedPose {
  Rigid3 target_from_source;
  double support = 0.0;
};

struct SeedOptions {
  double distance = 0.0;       // metres; a correspondence supports a pose if its points then are this near
  double cosine = 0.0;         // and its normals have at least this cosine
  double lever = 0.0;          // metres; weight of a normal beside a point
  double same_distance = 0.0;  // metres; poses nearer than this and than same_angle are one
  double same_angle_rad = 0.0;
  std::size_t max_count = 0;
};

// The pose with the least squares of the distances of points and, times the lever, of the differences of normals.
// Between the clouds' points. REQUIRES: there is a pair. The identity's rotation about what the pairs leave free.
Rigid3 fitted_pose(const KeyPoints& source, const KeyPoints& target, std::span<const Correspondence> pairs,
                   double lever);

// Each correspondence is a seed. It and those consistent with it that have the most others in common with it give a
// pose, and what supports that pose improves it. The best supported poses, best first. The result is bit-identical for
// any number of threads.
std::vector<SeedPose> seed_poses(const KeyPoints& source, const KeyPoints& target,
                                 std::span<const Correspondence> pairs, const ConsistencyGraph& graph,
                                 const SeedOptions& options, int num_threads);

}  // namespace augicp
