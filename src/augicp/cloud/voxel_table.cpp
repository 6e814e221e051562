// SPDX-License-Identifier: MIT
#include "augicp/cloud/voxel_table.h"

namespace augicp {
namespace {

constexpr int kFirstBits = 12;
constexpr std::size_t kSlotsPerKey = 4;

}  // namespace

VoxelTable::VoxelTable() : shift_(64 - kFirstBits), slots_(std::size_t{1} << kFirstBits, kFree) {}

std::size_t VoxelTable::added(std::uint64_t key) {
  const std::size_t number = keys_.size();
  slots_[slot_of(key)] = static_cast<std::uint32_t>(number);
  keys_.push_back(key);
  if (kSlotsPerKey * keys_.size() > slots_.size()) grow();
  return number;
}

void VoxelTable::grow() {
  --shift_;
  slots_.assign(2 * slots_.size(), kFree);
  for (std::size_t k = 0; k < keys_.size(); ++k) slots_[slot_of(keys_[k])] = static_cast<std::uint32_t>(k);
}

}  // namespace augicp
