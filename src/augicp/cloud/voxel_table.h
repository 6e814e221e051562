// SPDX-License-Identifier: MIT
// The occupied voxels of a cloud, numbered as their first points come. Internal.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "augicp/cloud/voxel_cells.h"

namespace augicp {

// A cell as one number; faster than its place on the curve.
inline std::uint64_t packed_key(const Parts& parts) {
  constexpr int kBits = 21;  // see kMaxCells
  const auto axis = [&](int k) { return static_cast<std::uint64_t>(parts[k] >> kPartBits); };
  return axis(0) | axis(1) << kBits | axis(2) << (2 * kBits);
}

// Numbers distinct keys 0, 1, 2... A table with open addressing, at most a quarter full, so that mostly the first slot
// is right. It grows with the keys: the few voxels of many points stay in the cache.
class VoxelTable {
 public:
  VoxelTable();
  std::size_t size() const { return keys_.size(); }

  // The number of a key, which is new if it equals the size before.
  std::size_t number_of(std::uint64_t key) {
    const std::uint32_t number = slots_[slot_of(key)];
    return number != kFree ? number : added(key);
  }

 private:
  static constexpr std::uint32_t kFree = UINT32_MAX;

  // Where the key is, or else the free slot for it.
  std::size_t slot_of(std::uint64_t key) const {
    constexpr std::uint64_t kGoldenRatio = 0x9e3779b97f4a7c15;  // multiplicative hashing, Knuth vol. 3, 6.4
    std::size_t slot = key * kGoldenRatio >> shift_;
    while (slots_[slot] != kFree && keys_[slots_[slot]] != key) slot = (slot + 1) & (slots_.size() - 1);
    return slot;
  }

  std::size_t added(std::uint64_t key);
  void grow();

  int shift_;
  std::vector<std::uint32_t> slots_;  // numbers
  std::vector<std::uint64_t> keys_;
};

}  // namespace augicp
