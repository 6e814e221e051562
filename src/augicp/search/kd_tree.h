// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <vector>

#include "augicp/cloud/cloud.h"

namespace augicp {

struct Neighbour {
  std::uint32_t index = 0;
  float distance_sq = 0.0f;
};

// The nearest points, nearest first; fewer if there are fewer.
inline constexpr std::size_t kFew = 3;
using NearestFew = std::array<std::optional<Neighbour>, kFew>;

// Nearest neighbours among the points of a cloud. Queries are relative to the cloud's origin, like its points; a query
// that is not finite finds nothing. Of points at the same squared distance, rounded to float, the one with the lower
// index is nearer. REQUIRES: the cloud outlives the tree, does not change, and has at most 2^32 - 1 points. Thread
// safety: queries may run concurrently.
class KdTree {
 public:
  explicit KdTree(const Cloud& cloud);
  ~KdTree();
  KdTree(KdTree&&) noexcept;
  KdTree& operator=(KdTree&&) noexcept;

  // The nearest point at a squared distance below max_distance_sq; empty if there is none.
  std::optional<Neighbour> nearest(const Vec3f& query, float max_distance_sq) const;

  // The same; faster if the point with the index `likely` is close. An index of no point is ignored.
  std::optional<Neighbour> nearest(const Vec3f& query, float max_distance_sq, std::uint32_t likely) const;

  // The kFew nearest points at a squared distance below max_distance_sq; faster if the points with the indices `likely`
  // are close. These must differ; if one is the index of no point, all are ignored.
  NearestFew nearest_few(const Vec3f& query, float max_distance_sq,
                         const std::array<std::uint32_t, kFew>& likely) const;

  // The squared distance of a point, rounded as in the results of queries.
  float distance_sq(const Vec3f& query, std::uint32_t index) const;

  // The count nearest points at a squared distance below max_distance_sq, nearest first; fewer if there are fewer.
  std::vector<Neighbour> nearest_k(const Vec3f& query, std::size_t count,
                                   float max_distance_sq = std::numeric_limits<float>::infinity()) const;

  // Appends the indices of all points at a squared distance of at most max_distance_sq, in no particular order.
  void append_within(const Vec3f& query, float max_distance_sq, std::vector<std::uint32_t>& found) const;

 private:
  struct Index;
  std::unique_ptr<Index> index_;
};

}  // namespace augicp
