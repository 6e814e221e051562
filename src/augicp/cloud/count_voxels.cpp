// SPDX-License-Identifier: MIT
#include <bit>
#include <utility>
#include <vector>

#include "augicp/cloud/voxel_cells.h"
#include "augicp/cloud/voxel_grid.h"
#include "augicp/core/check.h"

namespace augicp {
namespace {

// Distinct keys: a table with open addressing, at most half full. No key has its highest bit set.
class KeySet {
 public:
  explicit KeySet(std::size_t max_count)
      : shift_(64 - static_cast<int>(std::bit_width(2 * max_count))), slots_(std::size_t{1} << (64 - shift_), kFree) {}

  // Whether the key is new.
  bool insert(std::uint64_t key) {
    constexpr std::uint64_t kGoldenRatio = 0x9e3779b97f4a7c15;  // multiplicative hashing, Knuth vol. 3, 6.4
    std::size_t slot = key * kGoldenRatio >> shift_;
    while (slots_[slot] != kFree && slots_[slot] != key) slot = (slot + 1) & (slots_.size() - 1);
    return std::exchange(slots_[slot], key) == kFree;
  }

 private:
  static constexpr std::uint64_t kFree = ~std::uint64_t{0};
  int shift_;
  std::vector<std::uint64_t> slots_;
};

}  // namespace

std::size_t count_voxels(const Cloud& cloud, double voxel_size) {
  require_positive("voxel_size", voxel_size);
  if (cloud.empty()) return 0;
  const VoxelCells cells = voxel_cells(cloud, voxel_size);
  KeySet keys(cloud.size());
  std::size_t count = 0;
  for (const Vec3f& point : cloud.points) count += keys.insert(morton_key(cells.parts(point))) ? 1 : 0;
  return count;
}

}  // namespace augicp
