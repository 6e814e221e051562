// SPDX-License-Identifier: MIT
#include "augicp/surface/ball_neighbourhood.h"

#include <algorithm>
#include <atomic>

#include "augicp/core/check.h"
#include "augicp/core/parallel.h"

namespace augicp {
namespace {

constexpr std::size_t kPointsPerBlock = 256;

void find_neighbours(const KdTree& tree, const Vec3f& point, const BallOptions& options,
                     std::vector<Neighbour>& found) {
  const auto radius_sq = static_cast<float>(options.radius * options.radius);
  tree.within(point, radius_sq, found);
  if (found.size() < options.min_points && options.max_radius > options.radius) {
    const auto max_radius_sq = static_cast<float>(options.max_radius * options.max_radius);
    found = tree.nearest_k(point, options.min_points);
    std::erase_if(found, [&](const Neighbour& n) { return !(n.distance_sq < max_radius_sq); });
  }
}

// Lists of neighbours take four bytes each. A ball of four voxels, as registration has it, holds 300 points at most; where
// there are many more, all of them on average, the cloud was not thinned, and its lists would fill the memory.
constexpr std::size_t kMaxNeighboursPerPoint = 512;
constexpr std::size_t kFewNeighbours = std::size_t{1} << 24;  // of any cloud: 64 MB

std::size_t max_neighbours(std::size_t num_points) {
  return std::max(kFewNeighbours, kMaxNeighboursPerPoint * num_points);
}

// In index order: sums then do not depend on the shape of the tree.
void append_sorted(const std::vector<Neighbour>& found, std::vector<std::uint32_t>& neighbours) {
  const auto first = static_cast<std::ptrdiff_t>(neighbours.size());
  for (const Neighbour& n : found) neighbours.push_back(n.index);
  std::sort(neighbours.begin() + first, neighbours.end());
}

// As many rows as the compiler knows, so that a sum stays in registers.
template <int kRows>
using Rows = Eigen::Map<const Eigen::Array<double, kRows, Eigen::Dynamic>>;

template <int kRows>
void sum_of_neighbours(const Channels& values, const std::vector<std::size_t>& first_of,
                       const std::vector<std::uint32_t>& neighbours, std::size_t begin, std::size_t end,
                       Channels& sums) {
  const Rows<kRows> columns(values.data(), values.rows(), values.cols());
  for (std::size_t i = begin; i < end; ++i) {
    Eigen::Array<double, kRows, 1> sum = Eigen::Array<double, kRows, 1>::Zero(values.rows());
    for (std::size_t k = first_of[i]; k < first_of[i + 1]; ++k) sum += columns.col(neighbours[k]);
    sums.col(static_cast<Eigen::Index>(i)) = sum;
  }
}

}  // namespace

BallNeighbourhood::BallNeighbourhood(const Cloud& cloud, const BallOptions& options, int num_threads)
    : begin_(cloud.size() + 1, 0) {
  require_positive("radius", options.radius);
  require_not_negative("max_radius", options.max_radius);
  const KdTree tree(cloud);
  const std::size_t num_blocks = (cloud.size() + kPointsPerBlock - 1) / kPointsPerBlock;
  std::vector<std::vector<std::uint32_t>> of_block(num_blocks);
  std::atomic<std::size_t> num_neighbours{0};
  for_each_block(
      cloud.size(), num_threads,
      [&](std::size_t begin, std::size_t end) {
        std::vector<Neighbour> found;
        std::vector<std::uint32_t>& neighbours = of_block[begin / kPointsPerBlock];
        for (std::size_t i = begin; i < end; ++i) {
          find_neighbours(tree, cloud.points[i], options, found);
          begin_[i + 1] = found.size();
          require(num_neighbours.fetch_add(found.size()) + found.size() <= max_neighbours(cloud.size()), "radius",
                  options.radius, "the ball holds more than 512 points on average; thin the cloud, or use a smaller ball");
          append_sorted(found, neighbours);
        }
      },
      kPointsPerBlock);
  for (std::size_t i = 0; i < cloud.size(); ++i) begin_[i + 1] += begin_[i];
  neighbours_.reserve(begin_.back());
  for (const auto& neighbours : of_block) neighbours_.insert(neighbours_.end(), neighbours.begin(), neighbours.end());
}

Channels BallNeighbourhood::sum(const Channels& values, int num_threads) const {
  Channels sums(values.rows(), values.cols());
  for_each_block(static_cast<std::size_t>(values.cols()), num_threads, [&](std::size_t begin, std::size_t end) {
    switch (values.rows()) {
      case 7:
        return sum_of_neighbours<7>(values, begin_, neighbours_, begin, end, sums);
      case 10:
        return sum_of_neighbours<10>(values, begin_, neighbours_, begin, end, sums);
      default:
        return sum_of_neighbours<Eigen::Dynamic>(values, begin_, neighbours_, begin, end, sums);
    }
  });
  return sums;
}

}  // namespace augicp
