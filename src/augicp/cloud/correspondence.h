// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace augicp {

// A pair (j, i) of the paper: the indices of a source point and a target point that are assumed to be the same piece of
// surface.
struct Correspondence {
  std::uint32_t source = 0;
  std::uint32_t target = 0;
  bool operator==(const Correspondence&) const = default;
};

// The pairs of all blocks, in order.
inline std::vector<Correspondence> joined(const std::vector<std::vector<Correspondence>>& blocks) {
  std::size_t count = 0;
  for (const auto& block : blocks) count += block.size();
  std::vector<Correspondence> pairs;
  pairs.reserve(count);
  for (const auto& block : blocks) pairs.insert(pairs.end(), block.begin(), block.end());
  return pairs;
}

// At most max_count of the pairs, evenly spaced in their order: enough for medians and means.
inline std::vector<Correspondence> evenly_chosen(std::span<const Correspondence> pairs, std::size_t max_count) {
  const std::size_t step = (pairs.size() + max_count - 1) / max_count;
  std::vector<Correspondence> chosen;
  for (std::size_t k = 0; k < pairs.size(); k += step) chosen.push_back(pairs[k]);
  return chosen;
}

}  // namespace augicp
