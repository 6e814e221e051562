// SPDX-License-Identifier: MIT
#include "augicp/cloud/voxel_means.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <utility>

#include "augicp/cloud/voxel_table.h"

namespace augicp {
namespace {

// Their sums and the table fit into the cache of a core.
constexpr std::size_t kFewVoxels = std::size_t{1} << 14;

constexpr std::size_t kPointsAtOnce = 128;

struct Voxel {
  Parts corner, sum;  // sum: from the corner
  std::uint32_t first, count;
};

Vec3f mean_of(const Voxel& voxel, const Cloud& cloud, const VoxelCells& cells) {
  if (voxel.count == 1) return cloud.points[voxel.first];
  Vec3d mean;
  for (int k = 0; k < 3; ++k)
    mean[k] =
        static_cast<double>(voxel.corner[k]) + static_cast<double>(voxel.sum[k]) / static_cast<double>(voxel.count);
  return cells.place(mean).cast<float>();
}

}  // namespace

std::optional<std::vector<Vec3f>> few_voxel_means(const Cloud& cloud, const VoxelCells& cells) {
  VoxelTable table;
  std::vector<Voxel> voxels;
  std::array<Parts, kPointsAtOnce> block;
  for (std::uint32_t i = 0; i < cloud.size(); ++i) {
    if (i % kPointsAtOnce == 0)
      cells.write_parts(std::span(cloud.points).subspan(i, std::min<std::size_t>(kPointsAtOnce, cloud.size() - i)),
                        block);
    const Parts& parts = block[i % kPointsAtOnce];
    const std::size_t number = table.number_of(packed_key(parts));
    if (number == voxels.size()) {
      if (number == kFewVoxels) return std::nullopt;
      voxels.push_back(
          {{parts[0] - parts[0] % kParts, parts[1] - parts[1] % kParts, parts[2] - parts[2] % kParts}, {}, i, 0});
    }
    Voxel& voxel = voxels[number];
    for (int k = 0; k < 3; ++k) voxel.sum[k] += parts[k] - voxel.corner[k];
    ++voxel.count;
  }
  std::vector<std::pair<std::uint64_t, std::uint32_t>> order(voxels.size());
  for (std::uint32_t k = 0; k < voxels.size(); ++k) order[k] = {morton_key(voxels[k].corner), k};
  std::sort(order.begin(), order.end());
  std::vector<Vec3f> means;
  means.reserve(voxels.size());
  for (const auto& [key, k] : order) means.push_back(mean_of(voxels[k], cloud, cells));
  return means;
}

}  // namespace augicp
