// SPDX-License-Identifier: MIT
#include "augicp/search/kd_nodes.h"

#include <algorithm>
#include <bit>
#include <limits>
#include <span>

namespace augicp {
namespace {

// A point, with the bits of its index in the fourth place: moved as one vector.
using Item = FourFloats;
using Items = std::span<Item>;

constexpr float kInfinity = std::numeric_limits<float>::infinity();
constexpr std::uint32_t kNoIndex = std::numeric_limits<std::uint32_t>::max();

std::uint32_t stored_index(const Item& item) { return std::bit_cast<std::uint32_t>(item[3]); }

// The bounding box of some items; its fourth place has no meaning.
struct Box {
  FourFloats min = FourFloats{} + kInfinity, max = FourFloats{} - kInfinity;

  void add(const FourFloats& item) {
    min = item < min ? item : min;
    max = max < item ? item : max;
  }
  int longest_axis() const {
    const FourFloats side = max - min;
    return side[0] >= side[1] && side[0] >= side[2] ? 0 : side[1] >= side[2] ? 1 : 2;
  }
};

Box joined(const Box& a, const Box& b) { return {a.min < b.min ? a.min : b.min, a.max < b.max ? b.max : a.max}; }

// Alternates between two boxes, because each comparison waits for the one before.
Box box_of(Items items) {
  Box even, odd;
  std::size_t k = 0;
  for (; k + 1 < items.size(); k += 2) even.add(items[k]), odd.add(items[k + 1]);
  if (k < items.size()) even.add(items[k]);
  return joined(even, odd);
}

// Moves the items that satisfy is_low to the front and returns their number. Without a branch, which would be
// mispredicted half of the time.
template <typename IsLow>
std::size_t part(Items items, const IsLow& is_low) {
  std::size_t num_low = 0;
  for (Item& item : items) {
    const bool is_here = is_low(item);
    std::swap(item, items[num_low]);
    num_low += is_here ? 1 : 0;
  }
  return num_low;
}

// An estimate, from a sample, of the place-th value along an axis in sorted order.
float likely_at(Items items, std::size_t place, int axis) {
  std::array<float, 64> sample;
  const std::size_t count = std::clamp<std::size_t>(items.size() / 16, 1, sample.size());
  for (std::size_t k = 0; k < count; ++k) sample[k] = items[k * items.size() / count][axis];
  const auto at = sample.begin() + static_cast<std::ptrdiff_t>(place * count / items.size());
  std::nth_element(sample.begin(), at, sample.begin() + static_cast<std::ptrdiff_t>(count));
  return *at;
}

// Partitions the items at `middle` along an axis. Three times as fast as std::nth_element(), which finishes the work if
// few items are left, or after too many poor estimates.
void halve(Items items, std::size_t middle, int axis) {
  constexpr std::size_t kFew = 48;
  constexpr int kMaxRounds = 12;
  for (int round = 0; round < kMaxRounds && items.size() > kFew; ++round) {
    const float pivot = likely_at(items, middle, axis);
    std::size_t low = part(items, [=](const Item& item) { return item[axis] < pivot; });
    if (low == 0) {  // nothing is below the pivot: items equal to it go first
      low = part(items, [=](const Item& item) { return item[axis] <= pivot; });
      if (middle <= low) return;
    }
    if (middle == low) return;
    const bool is_in_low = middle < low;
    items = is_in_low ? items.first(low) : items.subspan(low);
    if (!is_in_low) middle -= low;
  }
  std::nth_element(items.begin(), items.begin() + static_cast<std::ptrdiff_t>(middle), items.end(),
                   [=](const Item& a, const Item& b) { return a[axis] < b[axis]; });
}

struct Part {
  Items items;
  Box box;
};

std::size_t num_leaves(Items items) { return (items.size() + KdLeaf::kPoints - 1) / KdLeaf::kPoints; }

// Two parts of about the same number of full children, split along the longest side. Equal points are split by index,
// so that a query finds them in few leaves. REQUIRES: more points than a child has.
std::array<Part, 2> halved(const Part& whole, std::size_t leaves_per_child) {
  const std::size_t num_children = (num_leaves(whole.items) + leaves_per_child - 1) / leaves_per_child;
  const std::size_t middle = (num_children + 1) / 2 * leaves_per_child * KdLeaf::kPoints;
  const int axis = whole.box.longest_axis();
  if (whole.box.min[axis] < whole.box.max[axis])
    halve(whole.items, middle, axis);
  else
    std::sort(whole.items.begin(), whole.items.end(),
              [](const Item& a, const Item& b) { return stored_index(a) < stored_index(b); });
  const Items low = whole.items.first(middle), high = whole.items.subspan(middle);
  return {Part{low, box_of(low)}, Part{high, box_of(high)}};
}

class Builder {
 public:
  explicit Builder(std::size_t num_points) {
    built_.leaves.reserve((num_points + KdLeaf::kPoints - 1) / KdLeaf::kPoints);
    built_.nodes.reserve(built_.leaves.capacity() / (KdNode::kChildren - 1) + 1);
  }

  std::uint32_t add_node(const Part& whole) {
    const auto place = static_cast<std::uint32_t>(built_.nodes.size());
    built_.nodes.push_back(kEmpty);
    std::size_t leaves_per_child = 1;  // all children are full except the last one
    while (leaves_per_child * KdNode::kChildren < num_leaves(whole.items)) leaves_per_child *= KdNode::kChildren;
    add_children(place, 0, whole, leaves_per_child);
    return place;
  }

  KdNodes take() { return std::move(built_); }

 private:
  static constexpr KdNode kEmpty = [] {
    KdNode node{};
    for (ManyFloats* side : {&node.min_x, &node.min_y, &node.min_z, &node.max_x, &node.max_y, &node.max_z})
      side->fill(kInfinity);
    node.least_index.fill(kNoIndex);
    return node;
  }();

  // Adds the children of a part of a node, from a slot on, and returns the slot behind them.
  std::size_t add_children(std::uint32_t node, std::size_t slot, const Part& part, std::size_t leaves_per_child) {
    if (num_leaves(part.items) <= leaves_per_child) {
      set_child(node, slot, part);
      return slot + 1;
    }
    for (const Part& half : halved(part, leaves_per_child)) slot = add_children(node, slot, half, leaves_per_child);
    return slot;
  }

  void set_child(std::uint32_t node, std::size_t slot, const Part& part) {
    std::uint32_t least_index = kNoIndex;
    for (const Item& item : part.items) least_index = std::min(least_index, stored_index(item));
    const std::uint32_t child = part.items.size() <= KdLeaf::kPoints ? add_leaf(part.items) : add_node(part);
    KdNode& parent = built_.nodes[node];
    parent.min_x[slot] = part.box.min[0], parent.max_x[slot] = part.box.max[0];
    parent.min_y[slot] = part.box.min[1], parent.max_y[slot] = part.box.max[1];
    parent.min_z[slot] = part.box.min[2], parent.max_z[slot] = part.box.max[2];
    parent.least_index[slot] = least_index;
    parent.child[slot] = child;
  }

  std::uint32_t add_leaf(Items items) {
    KdLeaf& leaf = built_.leaves.emplace_back();
    for (std::size_t k = 0; k < KdLeaf::kPoints; ++k) {
      const bool is_here = k < items.size();
      const Item item = is_here ? items[k] : FourFloats{} + kInfinity;
      leaf.x[k] = item[0], leaf.y[k] = item[1], leaf.z[k] = item[2];
      leaf.index[k] = is_here ? stored_index(item) : kNoIndex;
    }
    return static_cast<std::uint32_t>(built_.leaves.size() - 1) | KdNode::kIsLeaf;
  }

  KdNodes built_;
};

}  // namespace

KdNodes build_kd_nodes(const Cloud& cloud) {
  if (cloud.empty()) return {};
  std::vector<Item> items(cloud.size());
  for (std::uint32_t i = 0; i < items.size(); ++i) {
    const Vec3f& point = cloud.points[i];
    items[i] = FourFloats{point.x(), point.y(), point.z(), std::bit_cast<float>(i)};
  }
  Builder builder(items.size());
  builder.add_node({items, box_of(items)});
  return builder.take();
}

}  // namespace augicp
