// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "augicp/cloud/cloud.h"

namespace augicp {

// The points at these indices, in this order, with all that belongs to them.
Cloud select(const Cloud& cloud, const std::vector<std::uint32_t>& indices);

// At most max_count of the points, at even distances in their order; all where there are no more.
Cloud evenly_chosen(const Cloud& cloud, std::size_t max_count);

// One point a voxel: the mean of the points in it and of their intensities, with the direction, the structure and all
// else of the point nearest to that mean. Ordered along a space-filling (Morton) curve, so that neighbours in space
// become neighbours in memory, and independent of the order of the points, but for points at the same place: of those
// the first gives its direction. voxel_size in metres, above 0; throws std::invalid_argument where the cloud spans more
// than 2^21 voxels along an axis.
Cloud downsample(const Cloud& cloud, double voxel_size);

}  // namespace augicp
