// SPDX-License-Identifier: MIT
#include "augicp/cloud/voxel_cells.h"

#include <limits>

#include "augicp/core/check.h"

namespace augicp {

VoxelCells::VoxelCells(const Vec3f& min, double cell)
    : min_(min.cast<double>()), parts_per_metre_(std::min(kParts / cell, std::numeric_limits<double>::max())) {}

VoxelCells voxel_cells(const Cloud& cloud, double voxel_size) {
  const Bounds box = bounds(cloud);
  const double longest = (box.max.cast<double>() - box.min.cast<double>()).maxCoeff();
  require(longest / voxel_size < kMaxCells, "voxel_size", voxel_size,
          "too small, the cloud spans more than 2^21 voxels");
  // A cell larger than the cloud is not needed, and its parts would be too coarse for the cloud.
  return {box.min, longest > 0.0 ? std::min(voxel_size, 2.0 * longest) : voxel_size};
}

}  // namespace augicp
