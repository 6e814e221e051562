// SPDX-License-Identifier: MIT
#include "augicp/registration/voxel_radius.h"

#include <algorithm>
#include <cmath>

#include "augicp/cloud/voxel_grid.h"

namespace augicp {
namespace {

// The mean distance of neighbours on a surface: its area is about that of the occupied cells.
double spacing(const Cloud& cloud, double cell_size) {
  if (cloud.empty()) return 0.0;
  const std::size_t num_cells = count_voxels(cloud, feasible_voxel(cloud, cell_size));
  return cell_size * std::sqrt(static_cast<double>(num_cells) / static_cast<double>(cloud.size()));
}

}  // namespace

double radius_for(double voxel_size, const Scan& source, const Scan& target, const Lengths& derived) {
  if (source.view || target.view || !(derived.radius > 0.0)) return derived.radius;
  const double per_voxel = derived.radius / derived.voxel_size;
  const double sparse = std::max(spacing(source.cloud, derived.voxel_size), spacing(target.cloud, derived.voxel_size));
  return std::max(per_voxel * voxel_size, std::min(per_voxel * sparse, derived.radius));
}

}  // namespace augicp
