// SPDX-License-Identifier: MIT
// The memory that LiDAR odometry needs, known before a scan is worked on.
#pragma once

#include <cstddef>

#include "augicp/registration/memory.h"

namespace augicp {

// What a LidarOdometry keeps, and the next scan.
struct LidarMemory {
  std::size_t num_points = 0;  // of the scan
  std::size_t num_voxels = 0;  // of the map, with those that the scan may add
  std::size_t num_kept = 0;    // points of the keyframes of the self-check

  // 10^9 bytes.
  double gb() const;
};

// Throws TooMuchMemory if more than this is needed, 10^9 bytes. Its voxel size, metres, is expected to be enough: the
// number of the map's voxels is taken to fall as that of the scan's does. The scan is without far outliers.
void require_memory(const LidarMemory& needed, const Cloud& scan, double voxel_size, double max_gb);

}  // namespace augicp
