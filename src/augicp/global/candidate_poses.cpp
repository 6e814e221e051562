// SPDX-License-Identifier: MIT
#include "augicp/global/candidate_poses.h"

#include "augicp/core/angles.h"
#include "augicp/core/stop.h"
#include "augicp/global/alike.h"

namespace augicp {
namespace {

// In voxels. A voxel's mean moves by half a voxel with the grid, in either cloud.
constexpr double kConsistentVoxels = 1.5, kMinDistanceVoxels = 4.0, kSupportVoxels = 2.0, kLeverVoxels = 5.0,
                 kSameVoxels = 3.0;
constexpr double kConsistentCosine = 0.3, kSupportCosine = 0.7;
constexpr double kSameAngle = 8.0 * kRadPerDeg;

ConsistencyLimits consistency_limits(double voxel_size) {
  return {kConsistentVoxels * voxel_size, kMinDistanceVoxels * voxel_size, kConsistentCosine};
}

SeedOptions seed_options(double voxel_size, std::size_t max_count) {
  return {kSupportVoxels * voxel_size, kSupportCosine, kLeverVoxels * voxel_size,
          kSameVoxels * voxel_size,    kSameAngle,     max_count};
}

}  // namespace

std::vector<SeedPose> candidate_poses(const Cloud& source, const Cloud& target, const CandidateOptions& options) {
  const double voxel_size = common_voxel(source, target, options.voxel_size, options.max_points);
  const bool has_signs = normals_have_signs(source, target);
  const auto described_of = [&](const Cloud& cloud) {
    throw_if_stopped(options.stop);
    const auto viewpoint = has_signs ? cloud.viewpoint : std::nullopt;
    return described(key_cloud(cloud, voxel_size, viewpoint, options.num_threads), options.max_key_points,
                     options.num_threads);
  };
  const KeyPoints from = described_of(source), to = described_of(target);
  throw_if_stopped(options.stop);
  const auto pairs = alike_pairs(from, to, options.num_threads);
  throw_if_stopped(options.stop);
  const ConsistencyGraph graph(from, to, pairs, consistency_limits(voxel_size), options.num_threads);
  throw_if_stopped(options.stop);
  return seed_poses(from, to, pairs, graph, seed_options(voxel_size, options.max_poses), options.num_threads);
}

}  // namespace augicp
