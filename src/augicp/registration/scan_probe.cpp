// SPDX-License-Identifier: MIT
#include "augicp/registration/scan_probe.h"

#include <algorithm>
#include <numeric>

#include "augicp/cloud/voxel_grid.h"
#include "augicp/match/ray_spacing.h"
#include "augicp/registration/judge.h"

namespace augicp {
namespace {

constexpr std::size_t kMaxTestedPixels = 20000;

Cloud tested(const Scan& scan) {
  return scan.view && scan.cloud.size() > kMaxTestedPixels ? evenly_chosen(scan.cloud, kMaxTestedPixels) : scan.cloud;
}

std::optional<Vec3f> known_place(const Scan& scan) {
  return scan.place_is_known ? std::optional(assumed_place(scan.cloud)) : std::nullopt;
}

}  // namespace

ScanProbe::ScanProbe(const ScanPair& pair)
    : source_(tested(pair.source)),
      target_(tested(pair.target)),
      probe_({source_, known_place(pair.source)}, {target_, known_place(pair.target)},
             tolerance_of(pair.target, pair.lengths), pair.lengths.radius) {}

FreeDirections free_first(const Observability& seen, const std::vector<bool>& is_free) {
  std::vector<Eigen::Index> order(6);
  std::iota(order.begin(), order.end(), 0);
  std::stable_partition(order.begin(), order.end(),
                        [&](Eigen::Index k) { return is_free[static_cast<std::size_t>(k)]; });
  FreeDirections free{seen, static_cast<int>(std::count(is_free.begin(), is_free.end(), true))};
  for (Eigen::Index k = 0; k < 6; ++k) {
    free.seen.information[k] = seen.information[order[static_cast<std::size_t>(k)]];
    free.seen.directions.col(k) = seen.directions.col(order[static_cast<std::size_t>(k)]);
  }
  return free;
}

}  // namespace augicp
