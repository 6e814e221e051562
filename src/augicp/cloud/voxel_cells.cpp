// SPDX-License-Identifier: MIT
#include "augicp/cloud/voxel_cells.h"

#include <limits>

#include "augicp/core/check.h"
#include "augicp/core/vectorized.h"

namespace augicp {
namespace {

static_assert(sizeof(Vec3f) == 3 * sizeof(float) && sizeof(Parts) == 3 * sizeof(std::int64_t));

// Coordinates of whole points, and whole vectors of eight.
constexpr std::size_t kDoubleLanes = 24;

// Parts of the coordinates of points. REQUIRES: count is a multiple of kDoubleLanes.
AUGICP_VECTORIZED void write_parts_of(const float* __restrict coordinates, std::size_t count,
                                      const double* __restrict min, double parts_per_metre,
                                      std::int64_t* __restrict written) {
  for (std::size_t first = 0; first < count; first += kDoubleLanes)
    for (std::size_t lane = 0; lane < kDoubleLanes; ++lane) {
      const double parts = (static_cast<double>(coordinates[first + lane]) - min[lane]) * parts_per_metre;
      written[first + lane] = static_cast<std::int64_t>(parts < kMaxPart ? parts : kMaxPart);
    }
}

}  // namespace

void VoxelCells::write_parts(std::span<const Vec3f> points, std::span<Parts> written) const {
  if (points.empty()) return;
  std::array<double, kDoubleLanes> min;
  for (std::size_t lane = 0; lane < kDoubleLanes; ++lane) min[lane] = min_[static_cast<Eigen::Index>(lane % 3)];
  const std::size_t in_lanes = 3 * points.size() / kDoubleLanes * kDoubleLanes;
  write_parts_of(points.front().data(), in_lanes, min.data(), parts_per_metre_, written.front().data());
  for (std::size_t i = in_lanes / 3; i < points.size(); ++i) written[i] = parts(points[i]);
}

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
