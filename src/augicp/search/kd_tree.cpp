// SPDX-License-Identifier: MIT
// Code for AVX-512 takes a twentieth longer than that for AVX2: sixteen numbers are too few.
#ifndef AUGICP_NO_AVX512
#define AUGICP_NO_AVX512
#endif
#include "augicp/search/kd_tree.h"

#include <algorithm>
#include <bit>
#include <cstring>

#include "augicp/core/vectorized.h"
#include "augicp/search/first_few.h"
#include "augicp/search/kd_nodes.h"

namespace augicp {
namespace {

// Squared distances, and a bit for each that is not above a limit, from the lowest bit on.
struct Compared {
  alignas(64) ManyFloats distance_sq;
  std::uint32_t within;
};

AUGICP_INLINE void compare(float limit, Compared& compared) {
  std::uint32_t within = 0;
  for (std::uint32_t k = 0; k < kMany; ++k) within |= compared.distance_sq[k] <= limit ? 1U << k : 0U;
  compared.within = within;
}

// The distance of a number from an interval.
AUGICP_INLINE float outside(float min, float number, float max) {
  const float below = min - number, above = number - max, farther = below < above ? above : below;
  return farther > 0.0f ? farther : 0.0f;
}

// To the children's boxes. Rounded like distances to the points inside, so none of these is less.
AUGICP_INLINE void compare(const Vec3f& query, const KdNode& node, float limit, Compared& compared) {
  const float x = query.x(), y = query.y(), z = query.z();
  for (std::size_t k = 0; k < kMany; ++k) {
    const float dx = outside(node.min_x[k], x, node.max_x[k]), dy = outside(node.min_y[k], y, node.max_y[k]),
                dz = outside(node.min_z[k], z, node.max_z[k]);
    compared.distance_sq[k] = dx * dx + dy * dy + dz * dz;
  }
  compare(limit, compared);
}

// To a leaf's points.
AUGICP_INLINE void compare(const Vec3f& query, const KdLeaf& leaf, float limit, Compared& compared) {
  const float x = query.x(), y = query.y(), z = query.z();
  for (std::size_t k = 0; k < kMany; ++k) {
    const float dx = leaf.x[k] - x, dy = leaf.y[k] - y, dz = leaf.z[k] - z;
    compared.distance_sq[k] = dx * dx + dy * dy + dz * dz;
  }
  compare(limit, compared);
}

// Calls add(rank) for the points of a leaf that may have a rank below the limit: few of them once the limit is near.
template <typename Add>
AUGICP_INLINE void for_each_within(const KdLeaf& leaf, const Vec3f& query, Rank limit, const Add& add) {
  Compared compared;
  compare(query, leaf, distance_sq_of(limit), compared);
  for (std::uint32_t within = compared.within; within != 0; within &= within - 1) {
    const auto k = static_cast<std::size_t>(std::countr_zero(within));
    add(rank_of(compared.distance_sq[k], leaf.index[k]));
  }
}

// FirstFew with one rank.
class First {
 public:
  explicit First(Rank limit) : limit_(limit) {}
  AUGICP_INLINE Rank limit() const { return limit_; }
  AUGICP_INLINE void add(const KdLeaf& leaf, const Vec3f& query) {
    for_each_within(leaf, query, limit_, [&](Rank rank) { limit_ = std::min(limit_, rank); });
  }

 private:
  Rank limit_;
};

// First with kFew ranks.
class FirstOfFew {
 public:
  explicit FirstOfFew(Rank limit) { ranks_.fill(limit); }
  const std::array<Rank, kFew>& ranks() const { return ranks_; }
  AUGICP_INLINE Rank limit() const { return ranks_.back(); }
  AUGICP_INLINE void add(const KdLeaf& leaf, const Vec3f& query) {
    for_each_within(leaf, query, limit(), [&](Rank rank) {
      for (Rank& kept : ranks_) {  // keeps the lower and passes on the higher, without a branch
        const Rank lower = std::min(kept, rank);
        rank = std::max(kept, rank);
        kept = lower;
      }
    });
  }

 private:
  std::array<Rank, kFew> ranks_;
};

// FirstFew, of a leaf.
class FirstMany {
 public:
  FirstMany(std::size_t count, Rank limit) : first_(count, limit) {}
  AUGICP_INLINE Rank limit() const { return first_.limit(); }
  AUGICP_INLINE void add(const KdLeaf& leaf, const Vec3f& query) {
    Compared compared;
    compare(query, leaf, 0.0f, compared);
    first_.add(leaf, compared.distance_sq);
  }
  std::span<const Rank> sorted() { return first_.sorted(); }

 private:
  FirstFew first_;
};

// All points that are not above the limit. A missing one, at infinity, is none.
class AllWithin {
 public:
  AllWithin(float max_distance_sq, std::vector<std::uint32_t>& found)
      : limit_(std::min(rank_of(max_distance_sq, kNoPoint), kMissing)), found_(found) {}
  AUGICP_INLINE Rank limit() const { return limit_; }
  AUGICP_INLINE void add(const KdLeaf& leaf, const Vec3f& query) {
    for_each_within(leaf, query, limit_, [&](Rank rank) {
      if (rank != kMissing) found_.push_back(index_of(rank));
    });
  }

 private:
  static constexpr std::uint32_t kNoPoint = std::numeric_limits<std::uint32_t>::max();
  Rank limit_;
  std::vector<std::uint32_t>& found_;
};

std::optional<Neighbour> neighbour_below(Rank limit, Rank rank) {
  return rank < limit ? std::optional(Neighbour{index_of(rank), distance_sq_of(rank)}) : std::nullopt;
}

// A node or leaf that is still to be visited, see KdNode. No point in it has a lower rank.
struct Visit {
  Rank least;
  std::uint32_t child;
};

// At most fifteen stay open on a level. 2^32 points have seven levels, because each has a sixteenth of the leaves of
// the one above.
constexpr std::size_t kMaxOpen = 128;

// Adds the children that may have a point below the limit, the nearest last. Returns the end of the open ones.
AUGICP_INLINE Visit* open_children(const Vec3f& query, const KdNode& node, Rank limit, Visit* open) {
  Compared compared;
  compare(query, node, distance_sq_of(limit), compared);
  Visit* const first = open;
  for (std::uint32_t within = compared.within; within != 0; within &= within - 1) {
    const auto k = static_cast<std::size_t>(std::countr_zero(within));
    const Rank rank = rank_of(compared.distance_sq[k], node.least_index[k]);
    if (rank >= limit) continue;
    Visit* place = open++;
    for (; place != first && place[-1].least < rank; --place) *place = place[-1];
    *place = {rank, node.child[k]};
  }
  return open;
}

template <typename Kept>
AUGICP_INLINE void visit(const KdNodes& tree, const Vec3f& query, Kept& kept) {
  if (tree.nodes.empty()) return;
  std::array<Visit, kMaxOpen> open;
  Visit* end = open_children(query, tree.nodes.front(), kept.limit(), open.data());
  while (end != open.data()) {
    const Visit next = *--end;
    if (next.least >= kept.limit()) continue;
    if (next.child & KdNode::kIsLeaf)
      kept.add(tree.leaves[next.child & ~KdNode::kIsLeaf], query);
    else
      end = open_children(query, tree.nodes[next.child], kept.limit(), end);
  }
}

// One function for each kind of search, because templates are compiled for one instruction set.
AUGICP_VECTORIZED void find(const KdNodes& tree, const Vec3f& point, First& kept) { visit(tree, point, kept); }
AUGICP_VECTORIZED void find_few(const KdNodes& tree, const Vec3f& point, FirstOfFew& kept) { visit(tree, point, kept); }
AUGICP_VECTORIZED void find_many(const KdNodes& tree, const Vec3f& point, FirstMany& kept) { visit(tree, point, kept); }
AUGICP_VECTORIZED void find_all(const KdNodes& tree, const Vec3f& point, AllWithin& kept) { visit(tree, point, kept); }

// Rounded as in leaves.
float distance_sq_between(const Vec3f& point, const Vec3f& query) {
  const Vec3f apart = point - query;
  return apart.x() * apart.x() + apart.y() * apart.y() + apart.z() * apart.z();
}

}  // namespace

struct KdTree::Index {
  const std::vector<Vec3f>& points;
  KdNodes nodes;

  Rank rank(const Vec3f& query, std::uint32_t index) const {
    return index < points.size() ? rank_of(distance_sq_between(points[index], query), index) : kMissing;
  }
};

KdTree::KdTree(const Cloud& cloud) : index_(new Index{cloud.points, build_kd_nodes(cloud)}) {}
KdTree::~KdTree() = default;
KdTree::KdTree(KdTree&&) noexcept = default;
KdTree& KdTree::operator=(KdTree&&) noexcept = default;

std::optional<Neighbour> KdTree::nearest(const Vec3f& query, float max_distance_sq) const {
  return nearest(query, max_distance_sq, std::numeric_limits<std::uint32_t>::max());
}

std::optional<Neighbour> KdTree::nearest(const Vec3f& query, float max_distance_sq, std::uint32_t likely) const {
  if (!query.allFinite() || !(max_distance_sq > 0.0f)) return std::nullopt;
  const Rank gate = rank_of(max_distance_sq, 0);
  First first(std::min(gate, index_->rank(query, likely)));
  find(index_->nodes, query, first);
  return neighbour_below(gate, first.limit());
}

NearestFew KdTree::nearest_few(const Vec3f& query, float max_distance_sq,
                               const std::array<std::uint32_t, kFew>& likely) const {
  NearestFew found;
  if (!query.allFinite() || !(max_distance_sq > 0.0f)) return found;
  Rank farthest = 0;  // enough points are at most this far
  for (const std::uint32_t index : likely) farthest = std::max(farthest, index_->rank(query, index));
  const Rank limit = std::min(rank_of(max_distance_sq, 0), farthest + 1);
  FirstOfFew first(limit);
  find_few(index_->nodes, query, first);
  for (std::size_t k = 0; k < kFew; ++k) found[k] = neighbour_below(limit, first.ranks()[k]);
  return found;
}

float KdTree::distance_sq(const Vec3f& query, std::uint32_t index) const {
  return distance_sq_between(index_->points[index], query);
}

std::vector<Neighbour> KdTree::nearest_k(const Vec3f& query, std::size_t count, float max_distance_sq) const {
  count = std::min(count, index_->points.size());
  if (count == 0 || !query.allFinite() || !(max_distance_sq > 0.0f)) return {};
  const bool is_limited = max_distance_sq < std::numeric_limits<float>::infinity();
  FirstMany first(count, is_limited ? rank_of(max_distance_sq, 0) : kMissing);
  find_many(index_->nodes, query, first);
  std::vector<Neighbour> found;
  found.reserve(count);
  for (const Rank rank : first.sorted()) found.push_back({index_of(rank), distance_sq_of(rank)});
  return found;
}

void KdTree::append_within(const Vec3f& query, float max_distance_sq, std::vector<std::uint32_t>& found) const {
  if (!query.allFinite() || !(max_distance_sq >= 0.0f)) return;
  AllWithin within(max_distance_sq, found);
  find_all(index_->nodes, query, within);
}

}  // namespace augicp
