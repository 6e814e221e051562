// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "augicp/search/kd_tree.h"

namespace augicp {

// The nearest points of queries that come again, each a little moved, as those of a source under one pose of a loop after
// the other. A query that has moved by less than half of what its next point was farther away than its nearest has the same
// nearest point: that costs one distance in place of a search (the idea is that of Greenspan and Godin 2001, "A nearest
// neighbor method for efficient ICP"). What is found is what KdTree::nearest() finds, bit by bit, however queries move.
class NearestMemory {
 public:
  // Of queries 0, ..., num_queries - 1. The tree must outlive it.
  NearestMemory(const KdTree& tree, std::size_t num_queries) : tree_(tree), known_(num_queries) {}

  // likely: a query asked before whose place is not far, or this one. Calls for different queries may run concurrently if
  // they name no other as likely that another call is for.
  std::optional<Neighbour> nearest(std::size_t query, const Vec3f& place, float max_distance_sq, std::size_t likely);

 private:
  static constexpr std::uint32_t kNone = -1;

  struct Known {
    Vec3f place = Vec3f::Zero();
    std::array<std::uint32_t, 2> nearest{kNone, kNone};  // and the next, where they were below the gate
    float others_beyond = 0.0f;  // no point but the nearest was less far from the place, metres
  };

  const KdTree& tree_;
  std::vector<Known> known_;
};

}  // namespace augicp
