// SPDX-License-Identifier: MIT
#include "augicp/cloud/voxel_cells.h"
#include "augicp/cloud/voxel_grid.h"
#include "augicp/cloud/voxel_table.h"
#include "augicp/core/check.h"

namespace augicp {

std::size_t count_voxels(const Cloud& cloud, double voxel_size) {
  require_positive("voxel_size", voxel_size);
  if (cloud.empty()) return 0;
  const VoxelCells cells = voxel_cells(cloud, voxel_size);
  VoxelTable table;
  for (const Vec3f& point : cloud.points) table.number_of(packed_key(cells.parts(point)));
  return table.size();
}

}  // namespace augicp
