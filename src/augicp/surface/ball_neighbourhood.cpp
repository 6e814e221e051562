// SPDX-License-Identifier: MIT
#include "augicp/surface/ball_neighbourhood.h"

#include <algorithm>
#include <atomic>
#include <span>
#include <utility>

#include "augicp/core/check.h"
#include "augicp/core/parallel.h"
#include "augicp/search/kd_tree.h"
#include "augicp/surface/ball_candidates.h"
#include "augicp/surface/blocks.h"

namespace augicp {
namespace {

constexpr std::size_t kCellsPerBlock = 64;

// Lists of neighbours take four bytes per entry. A ball of four voxels, as in registration, has at most 300 points. If
// the average is much larger, the cloud was not downsampled, and its lists would fill the memory.
constexpr std::size_t kMaxNeighboursPerPoint = 512;
constexpr std::size_t kFewNeighbours = std::size_t{1} << 24;  // allowed for any cloud: 64 MB

// Appends the nearest min_points within the larger radius.
void append_nearest(const KdTree& tree, const Vec3f& centre, const BallOptions& options,
                    std::vector<std::uint32_t>& neighbours) {
  const auto max_radius_sq = static_cast<float>(options.max_radius * options.max_radius);
  for (const Neighbour& found : tree.nearest_k(centre, options.min_points, max_radius_sq))
    neighbours.push_back(found.index);
}

// The number of rows is known at compile time, so that a sum stays in registers.
template <int kRows>
using Rows = Eigen::Map<const Eigen::Array<double, kRows, Eigen::Dynamic>>;

template <int kRows>
Eigen::Array<double, kRows, 1> sum_of(const Rows<kRows>& columns, std::span<const std::uint32_t> neighbours) {
  Eigen::Array<double, kRows, 1> sum = Eigen::Array<double, kRows, 1>::Zero(columns.rows());
  for (const std::uint32_t k : neighbours) sum += columns.col(k);
  return sum;
}

double checked_radius(const BallOptions& options) {
  require_positive("radius", options.radius);
  return options.radius;
}

}  // namespace

std::size_t max_neighbours(std::size_t num_points) {
  return std::max(kFewNeighbours, kMaxNeighboursPerPoint * num_points);
}

BallNeighbourhood::BallNeighbourhood(const Cloud& cloud, const BallOptions& options, int num_threads)
    : BallNeighbourhood(cloud, CellGrid(cloud, checked_radius(options)), options, num_threads) {}

BallNeighbourhood::BallNeighbourhood(const Cloud& cloud, const CellGrid& grid, const BallOptions& options,
                                     int num_threads)
    : of_point_(cloud.size()) {
  checked_radius(options);
  require_not_negative("max_radius", options.max_radius);
  find_in_balls(cloud, grid, options, num_threads);
  if (options.min_points > 0 && options.max_radius > options.radius) widen_poor_balls(cloud, options, num_threads);
}

void BallNeighbourhood::find_in_balls(const Cloud& cloud, const CellGrid& grid, const BallOptions& options,
                                      int num_threads) {
  const auto radius_sq = static_cast<float>(options.radius * options.radius);
  append(Lists(1));               // of points that nothing is near
  if (radius_sq == 0.0f) return;  // no distance is below zero
  Lists lists((grid.num_cells() + kCellsPerBlock - 1) / kCellsPerBlock);
  std::atomic<std::size_t> num_neighbours{0};
  const auto find_in_cells = [&](std::size_t begin, std::size_t end) {
    BallCandidates candidates;
    CellGrid::Walk walk(grid, begin);
    std::vector<std::uint32_t>& neighbours = lists[begin / kCellsPerBlock].neighbours;
    for (std::size_t cell = begin; cell < end; ++cell) {
      walk.next(candidates.index());
      candidates.read(cloud);
      for (const std::uint32_t i : grid.points_of(cell)) {
        const std::size_t count = candidates.append_in_ball(cloud.points[i], radius_sq, neighbours);
        lists[begin / kCellsPerBlock].points.push_back({i, count});
        require(num_neighbours.fetch_add(count) + count <= max_neighbours(cloud.size()), "radius", options.radius,
                "the ball contains more than 512 points on average; downsample the cloud, or use a smaller ball");
      }
    }
    neighbours.shrink_to_fit();  // else a third of the memory is unused
  };
  for_each_block(grid.num_cells(), num_threads, find_in_cells, kCellsPerBlock);
  append(std::move(lists));
}

void BallNeighbourhood::widen_poor_balls(const Cloud& cloud, const BallOptions& options, int num_threads) {
  std::vector<std::uint32_t> poor;
  for (std::uint32_t i = 0; i < of_point_.size(); ++i)
    if (of_point_[i].count < options.min_points) poor.push_back(i);
  if (poor.empty()) return;
  const KdTree tree(cloud);
  Lists lists((poor.size() + kPointsPerBlock - 1) / kPointsPerBlock);
  const auto find_nearest = [&](std::size_t begin, std::size_t end) {
    List& list = lists[begin / kPointsPerBlock];
    for (std::size_t k = begin; k < end; ++k) {
      const std::size_t first = list.neighbours.size();
      append_nearest(tree, cloud.points[poor[k]], options, list.neighbours);
      list.points.push_back({poor[k], list.neighbours.size() - first});
    }
  };
  for_each_block(poor.size(), num_threads, find_nearest, kPointsPerBlock);
  append(std::move(lists));
}

// The lists stay where they were made: a copy of all would need their memory twice.
void BallNeighbourhood::append(Lists lists) {
  for (List& list : lists) {
    std::size_t begin = 0;
    for (const auto& [point, count] : list.points) {
      of_point_[point] = {begin, static_cast<std::uint32_t>(count), static_cast<std::uint32_t>(neighbours_.size())};
      begin += count;
    }
    neighbours_.push_back(std::move(list.neighbours));
  }
}

std::span<const std::uint32_t> BallNeighbourhood::neighbours_of(std::size_t point) const {
  const Range& range = of_point_[point];
  return std::span(neighbours_[range.list]).subspan(range.begin, range.count);
}

template <int kRows>
void BallNeighbourhood::sum_rows(const Channels& values, std::size_t begin, std::size_t end, Channels& sums) const {
  const Rows<kRows> columns(values.data(), values.rows(), values.cols());
  for (std::size_t i = begin; i < end; ++i)
    sums.col(static_cast<Eigen::Index>(i)) = sum_of<kRows>(columns, neighbours_of(i));
}

Channels BallNeighbourhood::sum(const Channels& values, int num_threads) const {
  Channels sums(values.rows(), values.cols());
  for_each_block(static_cast<std::size_t>(values.cols()), num_threads, [&](std::size_t begin, std::size_t end) {
    switch (values.rows()) {
      case 7:
        return sum_rows<7>(values, begin, end, sums);
      case 10:
        return sum_rows<10>(values, begin, end, sums);
      default:
        return sum_rows<Eigen::Dynamic>(values, begin, end, sums);
    }
  });
  return sums;
}

}  // namespace augicp
