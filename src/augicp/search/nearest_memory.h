// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "augicp/search/kd_tree.h"

namespace augicp {

// The nearest points of queries that come again, each a little moved, as those of a source under one pose of a loop
// after the other. Of each the nearest few are remembered. All others were at least as far away as the last of these:
// where one of them is nearer than that less the way that the query has moved, it is the nearest of all, and no search
// is needed (the idea is that of Greenspan and Godin 2001, "A nearest neighbor method for efficient ICP"). What is
// found is what KdTree::nearest() finds, bit by bit, however queries move.
class NearestMemory {
 public:
  // Of queries 0, ..., num_queries - 1. The tree must outlive it.
  NearestMemory(const KdTree& tree, std::size_t num_queries) : tree_(tree), known_(num_queries) {}

  // likely: a query asked before whose place is not far, or this one. Calls for different queries may run concurrently
  // if they name no other as likely that another call is for.
  std::optional<Neighbour> nearest(std::size_t query, const Vec3f& place, float max_distance_sq, std::size_t likely);

 private:
  static constexpr std::uint32_t kNone = -1;

  static_assert(kFew == 3);  // as many as named here
  struct Known {
    Vec3f place = Vec3f::Zero();
    std::array<std::uint32_t, kFew> nearest{kNone, kNone, kNone};
    float others_beyond = 0.0f;  // no other point was nearer to the place, metres
  };
  Neighbour nearest_known(const Known& known, const Vec3f& place) const;

  const KdTree& tree_;
  std::vector<Known> known_;
};

}  // namespace augicp
