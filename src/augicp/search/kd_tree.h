// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "augicp/cloud/cloud.h"

namespace augicp {

struct Neighbour {
  std::uint32_t index = 0;
  float distance_sq = 0.0f;
};

// The nearest points, nearest first, as far as there are any.
inline constexpr std::size_t kFew = 3;
using NearestFew = std::array<std::optional<Neighbour>, kFew>;

// Nearest neighbours among the points of a cloud, which must outlive the tree and stay as it is. Queries are relative
// to the cloud's origin, as its points are, and may run concurrently; one that is not finite finds nothing. Of points
// at the same squared distance, rounded to float, the one with the lower index is nearer. Of 2^32 - 1 points at most.
class KdTree {
 public:
  explicit KdTree(const Cloud& cloud);
  ~KdTree();
  KdTree(KdTree&&) noexcept;
  KdTree& operator=(KdTree&&) noexcept;

  // The nearest point at a distance below the square root of max_distance_sq, if there is one.
  std::optional<Neighbour> nearest(const Vec3f& query, float max_distance_sq) const;

  // The same, and sooner where `likely`, the index of a point, is not far. Indices of no point are ignored.
  std::optional<Neighbour> nearest(const Vec3f& query, float max_distance_sq, std::uint32_t likely) const;

  // The kFew nearest points at a distance below that; sooner where `likely`, the indices of different points, are not
  // far. An index of no point makes all of them void.
  NearestFew nearest_few(const Vec3f& query, float max_distance_sq,
                         const std::array<std::uint32_t, kFew>& likely) const;

  // The squared distance of a point, rounded as in what is found.
  float distance_sq(const Vec3f& query, std::uint32_t index) const;

  // The count nearest points, nearest first; fewer where the cloud has fewer.
  std::vector<Neighbour> nearest_k(const Vec3f& query, std::size_t count) const;

 private:
  struct Index;
  std::unique_ptr<Index> index_;
};

}  // namespace augicp
