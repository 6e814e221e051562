// SPDX-License-Identifier: MIT
// Poses between two clouds of which nothing is known, without chance: descriptors of extended points, pairs of similar
// ones, and groups of pairs that one motion explains.
#pragma once

#include <stop_token>

#include "augicp/global/seed_poses.h"

namespace augicp {

struct CandidateOptions {
  double voxel_size = 0.0;            // metres, above 0; larger for clouds with more than max_points
  std::size_t max_points = 5000;      // of each cloud, after downsampling
  std::size_t max_key_points = 1500;  // of each cloud, that are described
  std::size_t max_poses = 60;
  int num_threads = 0;
  std::stop_token stop{};
};

// Candidates for the pose between the clouds' points, the best supported first; none if nothing is alike. They are
// within a few voxels and degrees of what they stand for, and most are wrong: support is no evidence. Directions of the
// clouds are not used. Throws Interrupted once an end is requested. Thread safety: calls may run concurrently. The
// result is bit-identical for any number of threads.
std::vector<SeedPose> candidate_poses(const Cloud& source, const Cloud& target, const CandidateOptions& options);

}  // namespace augicp
