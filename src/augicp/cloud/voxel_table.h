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

// Numbers distinct keys 0, 1, 2... A table with open addressing, at most half full. It grows with the keys: the few
// voxels of many points stay in the cache.
class VoxelTable {
 public:
  VoxelTable();
  std::size_t size() const { return keys_.size(); }

  // The number of a key, which is new if it equals the size before. Neighbours in a scan mostly share their voxel.
  std::size_t number_of(std::uint64_t key) {
    if (key == last_key_) return last_;
    last_key_ = key;
    last_ = found_or_added(key);
    return last_;
  }

 private:
  static constexpr std::uint32_t kFree = UINT32_MAX;
  static constexpr std::uint64_t kNoKey = UINT64_MAX;
  std::size_t slot_of(std::uint64_t key) const;
  std::size_t found_or_added(std::uint64_t key);
  void grow();

  int shift_;
  std::vector<std::uint32_t> slots_;  // numbers
  std::vector<std::uint64_t> keys_;
  std::uint64_t last_key_ = kNoKey;
  std::size_t last_ = 0;
};

}  // namespace augicp
