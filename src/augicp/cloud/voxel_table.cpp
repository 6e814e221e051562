// SPDX-License-Identifier: MIT
#include "augicp/cloud/voxel_table.h"

namespace augicp {
namespace {

constexpr int kFirstBits = 12;

}  // namespace

VoxelTable::VoxelTable() : shift_(64 - kFirstBits), slots_(std::size_t{1} << kFirstBits, kFree) {}

// Where the key is, or else the free slot for it.
std::size_t VoxelTable::slot_of(std::uint64_t key) const {
  constexpr std::uint64_t kGoldenRatio = 0x9e3779b97f4a7c15;  // multiplicative hashing, Knuth vol. 3, 6.4
  std::size_t slot = key * kGoldenRatio >> shift_;
  while (slots_[slot] != kFree && keys_[slots_[slot]] != key) slot = (slot + 1) & (slots_.size() - 1);
  return slot;
}

std::size_t VoxelTable::found_or_added(std::uint64_t key) {
  std::uint32_t& number = slots_[slot_of(key)];
  if (number != kFree) return number;
  const std::size_t added = keys_.size();
  number = static_cast<std::uint32_t>(added);
  keys_.push_back(key);
  if (2 * keys_.size() > slots_.size()) grow();
  return added;
}

void VoxelTable::grow() {
  --shift_;
  slots_.assign(2 * slots_.size(), kFree);
  for (std::size_t k = 0; k < keys_.size(); ++k) slots_[slot_of(keys_[k])] = static_cast<std::uint32_t>(k);
}

}  // namespace augicp
