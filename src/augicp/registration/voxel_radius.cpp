// SPDX-License-Identifier: MIT
#include "augicp/registration/voxel_radius.h"

#include <algorithm>
#include <cmath>

#include "augicp/cloud/voxel_grid.h"
#include "augicp/core/parallel.h"

namespace augicp {
namespace {

// The mean distance of neighbours on a surface: its area is about that of the occupied cells.
double spacing(const Cloud& cloud, double cell_size) {
  if (cloud.empty()) return 0.0;
  const std::size_t num_cells = count_voxels(cloud, feasible_voxel(cloud, cell_size));
  return cell_size * std::sqrt(static_cast<double>(num_cells) / static_cast<double>(cloud.size()));
}

}  // namespace

double radius_for(double voxel_size, const Scan& source, const Scan& target, const Lengths& derived, int num_threads) {
  if (source.view || target.view || !(derived.radius > 0.0)) return derived.radius;
  const double per_voxel = derived.radius / derived.voxel_size;
  if (voxel_size > derived.voxel_size) return per_voxel * voxel_size;  // however sparse the points are
  const auto [of_source, of_target] = both(
      num_threads, [&] { return spacing(source.cloud, derived.voxel_size); },
      [&] { return spacing(target.cloud, derived.voxel_size); });
  const double sparse = std::max(of_source, of_target);
  return std::max(per_voxel * voxel_size, std::min(per_voxel * sparse, derived.radius));
}

}  // namespace augicp
