// SPDX-License-Identifier: MIT
#include "augicp/surface/ball_neighbourhood.h"

#include <algorithm>

#include "augicp/core/check.h"
#include "augicp/core/parallel.h"

namespace augicp {
namespace {

constexpr std::size_t kPointsPerBlock = 256;

// In index order: sums then do not depend on the shape of the tree.
void sort_by_index(std::vector<Neighbour>& found) {
  std::sort(found.begin(), found.end(), [](const Neighbour& a, const Neighbour& b) { return a.index < b.index; });
}

void find_neighbours(const KdTree& tree, const Vec3f& point, const BallOptions& options,
                     std::vector<Neighbour>& found) {
  const auto radius_sq = static_cast<float>(options.radius * options.radius);
  tree.within(point, radius_sq, found);
  if (found.size() < options.min_points && options.max_radius > options.radius) {
    const auto max_radius_sq = static_cast<float>(options.max_radius * options.max_radius);
    found = tree.nearest_k(point, options.min_points);
    std::erase_if(found, [&](const Neighbour& n) { return !(n.distance_sq < max_radius_sq); });
  }
  sort_by_index(found);
}

}  // namespace

BallNeighbourhood::BallNeighbourhood(const Cloud& cloud, const BallOptions& options, int num_threads)
    : begin_(cloud.size() + 1, 0) {
  require_positive("radius", options.radius);
  require_not_negative("max_radius", options.max_radius);
  const KdTree tree(cloud);
  const std::size_t num_blocks = (cloud.size() + kPointsPerBlock - 1) / kPointsPerBlock;
  std::vector<std::vector<std::uint32_t>> of_block(num_blocks);
  for_each_block(
      cloud.size(), num_threads,
      [&](std::size_t begin, std::size_t end) {
        std::vector<Neighbour> found;
        std::vector<std::uint32_t>& neighbours = of_block[begin / kPointsPerBlock];
        for (std::size_t i = begin; i < end; ++i) {
          find_neighbours(tree, cloud.points[i], options, found);
          begin_[i + 1] = found.size();
          for (const Neighbour& n : found) neighbours.push_back(n.index);
        }
      },
      kPointsPerBlock);
  for (std::size_t i = 0; i < cloud.size(); ++i) begin_[i + 1] += begin_[i];
  neighbours_.reserve(begin_.back());
  for (const auto& neighbours : of_block) neighbours_.insert(neighbours_.end(), neighbours.begin(), neighbours.end());
}

Channels BallNeighbourhood::sum(const Channels& values, int num_threads) const {
  Channels sums = Channels::Zero(values.rows(), values.cols());
  for_each_block(static_cast<std::size_t>(values.cols()), num_threads, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
      for (std::size_t k = begin_[i]; k < begin_[i + 1]; ++k)
        sums.col(static_cast<Eigen::Index>(i)) += values.col(neighbours_[k]);
  });
  return sums;
}

}  // namespace augicp
