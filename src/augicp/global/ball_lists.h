// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "augicp/cloud/cloud.h"

namespace augicp {

// For each point of one cloud, the points of another (or of the same) within a radius. Indices are in an order that
// depends on the clouds only. Thread safety: const calls may run concurrently.
class BallLists {
 public:
  BallLists() = default;  // of no query

  // Both clouds must have the same origin. radius: metres, above 0. REQUIRES: the support spans fewer than 2^20 radii.
  BallLists(const std::vector<Vec3f>& queries, const std::vector<Vec3f>& support, double radius, int num_threads);

  // Of the support, around the query; the query's own index is among them if it is of the support.
  std::span<const std::uint32_t> around(std::size_t query) const {
    return {indices_.data() + begin_[query], begin_[query + 1] - begin_[query]};
  }

 private:
  std::vector<std::size_t> begin_;
  std::vector<std::uint32_t> indices_;
};

}  // namespace augicp
