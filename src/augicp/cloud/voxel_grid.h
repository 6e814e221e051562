// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "augicp/cloud/cloud.h"

namespace augicp {

// The points at these indices, in this order, with all their attributes.
Cloud select(const Cloud& cloud, const std::vector<std::uint32_t>& indices);

// At most max_count of the points, evenly spaced in their order.
Cloud evenly_chosen(const Cloud& cloud, std::size_t max_count);

// One point per voxel: the mean of its points and of their intensities, with all other attributes of the point nearest
// to that mean. Points are ordered along a space-filling (Morton) curve, so neighbours in space are neighbours in
// memory. The result does not depend on the order of the input, except among points at the same position: there the
// first one gives the direction. voxel_size in metres, above 0. Throws std::invalid_argument if the cloud spans more
// than 2^21 voxels along an axis.
Cloud downsample(const Cloud& cloud, double voxel_size);

// How many points downsample() would return, in a fraction of its time. Throws as it does.
std::size_t count_voxels(const Cloud& cloud, double voxel_size);

}  // namespace augicp
