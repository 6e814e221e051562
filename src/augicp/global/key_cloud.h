// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include "augicp/cloud/cloud.h"
#include "augicp/global/ball_lists.h"

namespace augicp {

// A cloud of a few thousand points, evenly spaced, for descriptors. Points are relative to the origin of the cloud it
// was made of.
struct KeyCloud {
  std::vector<Vec3f> points;
  std::vector<Vec3f> normals;    // unit; zero if the points around lie on a line, or are too few
  std::vector<float> variation;  // l0 / (l0 + l1 + l2) of the points in the ball of the descriptor, in [0, 1/3]
  double voxel_size = 0.0;       // metres
  BallLists balls;               // of each point, as large as the ball of the descriptor

  // Position of the sensor, if normals point to it. If not set, a normal and its opposite are the same.
  std::optional<Vec3f> viewpoint;

  bool has_signs() const { return viewpoint.has_value(); }

  std::size_t size() const { return points.size(); }
};

// The voxel size, at least this one, with which neither cloud has more than max_points points; metres.
double common_voxel(const Cloud& source, const Cloud& target, double least_voxel_size, std::size_t max_points);

// Radius of the ball of the descriptor.
inline constexpr double kBallVoxels = 5.0;

// One point per voxel; normals from the points within a few voxels, towards the viewpoint if it is set. The result is
// bit-identical for any number of threads.
KeyCloud key_cloud(const Cloud& cloud, double voxel_size, const std::optional<Vec3f>& viewpoint, int num_threads);

}  // namespace augicp
