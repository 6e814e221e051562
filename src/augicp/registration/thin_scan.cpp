// SPDX-License-Identifier: MIT
#include "augicp/registration/thin_scan.h"

#include <algorithm>
#include <utility>

#include "augicp/cloud/voxel_grid.h"
#include "augicp/core/parallel.h"

namespace augicp {

Scan thinned(const Scan& scan, int step) {
  if (step <= 1) return scan;
  const IndexImage& seen = scan.view->index;
  Scan::View view = *scan.view;
  view.index = IndexImage(seen.width / step, seen.height / step);
  view.camera = thinned(scan.view->camera, step);
  std::vector<std::uint32_t> chosen;
  for (int v = 0; v < view.index.height; ++v)
    for (int u = 0; u < view.index.width; ++u) {
      const std::int32_t i = seen.at(u * step, v * step);
      if (i == IndexImage::kNone) continue;
      view.index.index[static_cast<std::size_t>(v) * view.index.width + u] = static_cast<std::int32_t>(chosen.size());
      chosen.push_back(static_cast<std::uint32_t>(i));
    }
  return {select(scan.cloud, chosen), std::move(view)};
}

int step_for(const Scan& scan, int num_columns) { return std::max(1, scan.view->index.width / num_columns); }

Scan coarser(const Scan& scan, int num_columns, double voxels, const Lengths& lengths) {
  if (scan.view) return thinned(scan, step_for(scan, num_columns));
  return {downsample(scan.cloud, feasible_voxel(scan.cloud, voxels * lengths.voxel_size)), std::nullopt,
          scan.place_is_known};
}

PreparedPair coarser(const ScanPair& pair, int num_columns, double voxels, int num_threads) {
  auto [source, target] = both(
      num_threads, [&] { return coarser(pair.source, num_columns, voxels, pair.lengths); },
      [&] { return coarser(pair.target, num_columns, voxels, pair.lengths); });
  return {std::move(source), std::move(target), pair.lengths};
}

}  // namespace augicp
