// SPDX-License-Identifier: MIT
// The memory of a KdTree: points and boxes in the order in which a query reads them. Not for users of the library.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "augicp/cloud/cloud.h"

namespace augicp {

// Four or sixteen numbers at once. The compiler makes one vector of four on any x86-64 and ARM.
using FourFloats [[gnu::vector_size(16)]] = float;

// Points side by side. What is missing in the last leaf lies at infinity, with an index above all others.
struct KdLeaf {
  static constexpr std::size_t kPoints = 16;
  std::array<FourFloats, kPoints / 4> x, y, z;
  std::array<std::uint32_t, kPoints> index;
};

// The boxes around the points of its children, which are nodes or leaves. A box that is missing lies at infinity.
struct KdNode {
  static constexpr std::size_t kChildren = 4;
  FourFloats min_x, min_y, min_z, max_x, max_y, max_z;
  std::array<std::uint32_t, kChildren> least_index;  // of the points in the box
  std::array<std::uint32_t, kChildren> child;        // the place of a node, or of a leaf with kIsLeaf
  static constexpr std::uint32_t kIsLeaf = std::uint32_t{1} << 31;
};

struct KdNodes {
  std::vector<KdNode> nodes;  // the first is the root
  std::vector<KdLeaf> leaves;
};

// Halves the points at the median of their longest side, down to leaves that are full but for the last. So the depth
// depends on nothing but the number of points, however they lie. None for an empty cloud.
KdNodes build_kd_nodes(const Cloud& cloud);

}  // namespace augicp
