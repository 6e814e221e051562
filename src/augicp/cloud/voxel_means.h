// SPDX-License-Identifier: MIT
// The mean points of a cloud's voxels. Internal.
#pragma once

#include <optional>
#include <vector>

#include "augicp/cloud/voxel_cells.h"

namespace augicp {

// In the order of the curve. None if there are so many voxels that sorting all points is faster. Sums are of integers,
// so the means are those of sorted points. REQUIRES: a point.
std::optional<std::vector<Vec3f>> few_voxel_means(const Cloud& cloud, const VoxelCells& cells);

}  // namespace augicp
