// SPDX-License-Identifier: MIT
#include "augicp/search/kd_tree.h"

#include <algorithm>
#include <bit>
#include <cstring>

#include "augicp/search/first_few.h"
#include "augicp/search/kd_nodes.h"

namespace augicp {
namespace {

// A point, with each coordinate four times.
struct Query {
  explicit Query(const Vec3f& point)
      : x(FourFloats{} + point.x()), y(FourFloats{} + point.y()), z(FourFloats{} + point.z()) {}
  FourFloats x, y, z;
};

// The distance of a number from an interval.
FourFloats outside(const FourFloats& min, const FourFloats& number, const FourFloats& max) {
  const FourFloats below = min - number, above = number - max, farther = below < above ? above : below;
  return farther > 0.0f ? farther : FourFloats{};
}

// Squared distances to the children's boxes. Rounded like distances to the points inside, so none of these is less.
FourFloats distances_sq(const Query& query, const KdNode& node) {
  const FourFloats dx = outside(node.min_x, query.x, node.max_x), dy = outside(node.min_y, query.y, node.max_y),
                   dz = outside(node.min_z, query.z, node.max_z);
  return dx * dx + dy * dy + dz * dz;
}

// Squared distances to four of a leaf's points.
FourFloats distances_sq(const Query& query, const KdLeaf& leaf, std::size_t four) {
  const FourFloats dx = leaf.x[four] - query.x, dy = leaf.y[four] - query.y, dz = leaf.z[four] - query.z;
  return dx * dx + dy * dy + dz * dz;
}

std::array<float, KdLeaf::kPoints> distances_sq(const Query& query, const KdLeaf& leaf) {
  std::array<float, KdLeaf::kPoints> all;
  for (std::size_t four = 0; four < leaf.x.size(); ++four) {
    const FourFloats sum = distances_sq(query, leaf, four);
    std::memcpy(all.data() + 4 * four, &sum, sizeof sum);
  }
  return all;
}

// A bit for each number of four that is not above the limit, from the lowest bit on. (Comparisons give -1 or 0.)
using FourBits [[gnu::vector_size(16)]] = std::int32_t;
FourBits bits_within(const FourFloats& numbers, float limit, std::int32_t first_bit) {
  return (numbers <= FourFloats{} + limit) & FourBits{first_bit, first_bit << 1, first_bit << 2, first_bit << 3};
}

std::uint32_t joined(const FourBits& bits) {
  std::array<std::uint64_t, 2> halves;
  std::memcpy(halves.data(), &bits, sizeof bits);
  const std::uint64_t both = halves[0] | halves[1];
  return static_cast<std::uint32_t>(both | both >> 32);
}

// Calls add(rank) for the points of a leaf that may have a rank below the limit: few of them once the limit is near.
template <typename Add>
void for_each_within(const KdLeaf& leaf, const Query& query, Rank limit, const Add& add) {
  std::array<float, KdLeaf::kPoints> distance_sq;
  FourBits bits{};
  for (std::size_t four = 0; four < leaf.x.size(); ++four) {
    const FourFloats sum = distances_sq(query, leaf, four);
    std::memcpy(distance_sq.data() + 4 * four, &sum, sizeof sum);
    bits |= bits_within(sum, distance_sq_of(limit), 1 << 4 * four);
  }
  for (std::uint32_t within = joined(bits); within != 0; within &= within - 1) {
    const auto k = static_cast<std::size_t>(std::countr_zero(within));
    add(rank_of(distance_sq[k], leaf.index[k]));
  }
}

// FirstFew with one rank.
class First {
 public:
  explicit First(Rank limit) : limit_(limit) {}
  Rank limit() const { return limit_; }
  void add(const KdLeaf& leaf, const Query& query) {
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
  Rank limit() const { return ranks_.back(); }
  void add(const KdLeaf& leaf, const Query& query) {
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
  Rank limit() const { return first_.limit(); }
  void add(const KdLeaf& leaf, const Query& query) { first_.add(leaf, distances_sq(query, leaf)); }
  std::span<const Rank> sorted() { return first_.sorted(); }

 private:
  FirstFew first_;
};

// All points that are not above the limit. A missing one, at infinity, is none.
class AllWithin {
 public:
  AllWithin(float max_distance_sq, std::vector<std::uint32_t>& found)
      : limit_(std::min(rank_of(max_distance_sq, kNoPoint), kMissing)), found_(found) {}
  Rank limit() const { return limit_; }
  void add(const KdLeaf& leaf, const Query& query) {
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

// At most three stay open on a level. 2^32 points have 15 levels, because each has a fourth of the leaves of the one
// above.
constexpr std::size_t kMaxOpen = 64;

// Adds the children that may have a point below the limit, the nearest last. Returns the end of the open ones.
Visit* open_children(const Query& query, const KdNode& node, Rank limit, Visit* open) {
  const FourFloats distance_sq = distances_sq(query, node);
  Visit* const first = open;
  for (std::uint32_t within = joined(bits_within(distance_sq, distance_sq_of(limit), 1)); within != 0;
       within &= within - 1) {
    const auto k = static_cast<std::size_t>(std::countr_zero(within));
    const Rank rank = rank_of(distance_sq[k], node.least_index[k]);
    if (rank >= limit) continue;
    Visit* place = open++;
    for (; place != first && place[-1].least < rank; --place) *place = place[-1];
    *place = {rank, node.child[k]};
  }
  return open;
}

template <typename Kept>
void visit(const KdNodes& tree, const Vec3f& point, Kept& kept) {
  if (tree.nodes.empty()) return;
  const Query query(point);
  std::array<Visit, kMaxOpen> open;
  Visit* end = open_children(query, tree.nodes.front(), kept.limit(), open.data());
  while (end != open.data()) {
    const Visit next = *--end;
    if (next.least >= kept.limit()) continue;
    if (next.child & KdNode::kIsLeaf) {
      const KdLeaf& leaf = tree.leaves[next.child & ~KdNode::kIsLeaf];
      kept.add(leaf, query);
    } else {
      end = open_children(query, tree.nodes[next.child], kept.limit(), end);
    }
  }
}

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
  visit(index_->nodes, query, first);
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
  visit(index_->nodes, query, first);
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
  visit(index_->nodes, query, first);
  std::vector<Neighbour> found;
  found.reserve(count);
  for (const Rank rank : first.sorted()) found.push_back({index_of(rank), distance_sq_of(rank)});
  return found;
}

void KdTree::append_within(const Vec3f& query, float max_distance_sq, std::vector<std::uint32_t>& found) const {
  if (!query.allFinite() || !(max_distance_sq >= 0.0f)) return;
  AllWithin within(max_distance_sq, found);
  visit(index_->nodes, query, within);
}

}  // namespace augicp
