// SPDX-License-Identifier: MIT
// The memory of a KdTree: points and boxes in the order in which a query reads them. Internal.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "augicp/cloud/cloud.h"

namespace augicp {

// One vector of four on any x86-64 and ARM.
using FourFloats [[gnu::vector_size(16)]] = float;

// Numbers that are computed at once, as wide as the machine's vectors are.
inline constexpr std::size_t kMany = 16;
using ManyFloats = std::array<float, kMany>;

// Points side by side. Missing points of the last leaf are at infinity, with an index above all others.
struct alignas(64) KdLeaf {
  static constexpr std::size_t kPoints = kMany;
  ManyFloats x, y, z;
  std::array<std::uint32_t, kPoints> index;
};

// The boxes around the points of its children, which are nodes or leaves. A missing box is at infinity.
struct alignas(64) KdNode {
  static constexpr std::size_t kChildren = kMany;
  ManyFloats min_x, min_y, min_z, max_x, max_y, max_z;
  std::array<std::uint32_t, kChildren> least_index;  // lowest index of the points in the box
  std::array<std::uint32_t, kChildren> child;        // index of a node, or of a leaf with kIsLeaf set
  static constexpr std::uint32_t kIsLeaf = std::uint32_t{1} << 31;
};

struct KdNodes {
  std::vector<KdNode> nodes;  // the first is the root
  std::vector<KdLeaf> leaves;
};

// Splits the points near the median of the longest side of their box, down to leaves that are all full except the last
// one. The depth depends only on the number of points, not on their positions. Empty for an empty cloud.
KdNodes build_kd_nodes(const Cloud& cloud);

}  // namespace augicp
