// SPDX-License-Identifier: MIT
// Which correspondences one rigid motion may explain together, and how many others support each two of them: Z. Chen,
// K. Sun, F. Yang, W. Tao, "SC2-PCR: A Second Order Spatial Compatibility for Efficient and Robust Point Cloud
// Registration", CVPR 2022. Here two correspondences are also compared by the angles of their normals.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "augicp/cloud/correspondence.h"
#include "augicp/global/descriptors.h"

namespace augicp {

struct ConsistencyLimits {
  double distance = 0.0;      // metres; the distances between two points of either cloud differ by at most this
  double min_distance = 0.0;  // metres; two points nearer than this say little about a rotation
  double cosine = 0.0;        // the cosines of the angles differ by at most this
};

// One row of bits for each correspondence: with which others it is consistent. Symmetric, the diagonal is zero.
class ConsistencyGraph {
 public:
  // The result is bit-identical for any number of threads.
  ConsistencyGraph(const KeyPoints& source, const KeyPoints& target, std::span<const Correspondence> pairs,
                   const ConsistencyLimits& limits, int num_threads);

  std::size_t size() const { return size_; }
  bool are_consistent(std::size_t a, std::size_t b) const { return row(a)[b / 64] >> (b % 64) & 1; }

  // The correspondences that are consistent with one, in ascending order.
  std::vector<std::uint32_t> consistent_with(std::size_t a) const;

  // How many correspondences are consistent with both.
  int num_common(std::size_t a, std::size_t b) const;

 private:
  const std::uint64_t* row(std::size_t a) const { return bits_.data() + a * words_; }

  std::size_t size_, words_;
  std::vector<std::uint64_t> bits_;
};

}  // namespace augicp
