// SPDX-License-Identifier: MIT
#include "augicp/registration/far_outliers.h"

#include <cstdint>
#include <vector>

#include "augicp/cloud/voxel_grid.h"
#include "augicp/registration/lengths.h"

namespace augicp {

void drop_far_outliers(Cloud& cloud, double reach) {
  if (cloud.empty() || bounds(cloud).diagonal() <= reach) return;  // the median point lies within
  const Vec3f centre = median_point(cloud);
  std::vector<std::uint32_t> within;
  for (std::uint32_t i = 0; i < cloud.size(); ++i)
    if ((cloud.points[i] - centre).norm() <= static_cast<float>(reach)) within.push_back(i);
  if (within.size() < cloud.size()) cloud = select(cloud, within);
}

}  // namespace augicp
