// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "augicp/search/kd_tree.h"

namespace augicp {

// Nearest neighbours of queries that repeat with small motions, such as the source points in the iterations of a
// registration. Results are bit-identical to KdTree::nearest(), for any motion of the queries.
//
// For each query the kFew nearest points of the last search are remembered, with d_last, the distance of the last of
// them. Invariant: no other point was closer than d_last to the query's last searched place. If the query moved by m
// since then, and a remembered point is now closer than d_last - m, that point is the nearest; no search is needed. The
// idea is from Greenspan and Godin 2001, "A nearest neighbor method for efficient ICP".
class NearestMemory {
 public:
  // For queries 0, ..., num_queries - 1. REQUIRES: the tree outlives the memory.
  NearestMemory(const KdTree& tree, std::size_t num_queries) : tree_(tree), known_(num_queries) {}

  // The nearest tree point to `place`, at a squared distance below max_distance_sq; empty if there is none. likely: a
  // query that was asked before and whose place is close, or this query itself. Thread safety: calls for different
  // queries may run concurrently if no call names as `likely` a query of another call.
  std::optional<Neighbour> nearest(std::size_t query, const Vec3f& place, float max_distance_sq, std::size_t likely);

 private:
  static constexpr std::uint32_t kNone = -1;

  static_assert(kFew == 3);  // one initialiser per remembered point
  struct Known {
    Vec3f place = Vec3f::Zero();
    std::array<std::uint32_t, kFew> nearest{kNone, kNone, kNone};
    float others_beyond = 0.0f;  // d_last: no other point was closer to the place, metres
  };
  Neighbour nearest_known(const Known& known, const Vec3f& place) const;

  const KdTree& tree_;
  std::vector<Known> known_;
};

}  // namespace augicp
