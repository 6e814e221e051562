// SPDX-License-Identifier: MIT
#include "augicp/surface/ball_size.h"

#include <algorithm>
#include <numbers>

namespace augicp {
namespace {

// The mean of 512 balls errs by three per cent where balls differ by two thirds of their size.
constexpr std::size_t kNumBalls = 512;

// Candidates around one point that are looked at; of more, evenly spaced ones.
constexpr std::size_t kMaxLookedAt = 4096;

// Once this many candidates were listed, the balls so far are enough: they are far too large to be searched.
constexpr std::size_t kMaxListed = std::size_t{1} << 24;

// Places spread evenly over [0, count), whatever number of them is used.
std::size_t spread_place(std::size_t k, std::size_t count) {
  const double turns = static_cast<double>(k) * std::numbers::phi;
  const double share = turns - static_cast<double>(static_cast<std::size_t>(turns));
  return std::min(count - 1, static_cast<std::size_t>(share * static_cast<double>(count)));
}

double num_in_ball(const Cloud& cloud, const std::vector<std::uint32_t>& candidates, const Vec3f& centre,
                   float radius_sq) {
  const std::size_t step = (candidates.size() + kMaxLookedAt - 1) / kMaxLookedAt;
  std::size_t num_looked_at = 0, num_within = 0;
  for (std::size_t k = 0; k < candidates.size(); k += step, ++num_looked_at)
    num_within += (cloud.points[candidates[k]] - centre).squaredNorm() < radius_sq ? 1 : 0;
  return static_cast<double>(num_within) * static_cast<double>(candidates.size()) / static_cast<double>(num_looked_at);
}

}  // namespace

double mean_ball_size(const Cloud& cloud, const CellGrid& grid, double radius) {
  const std::size_t num_balls = std::min(kNumBalls, grid.num_points());
  const auto radius_sq = static_cast<float>(radius * radius);
  if (radius_sq == 0.0f) return 0.0;
  std::vector<std::uint32_t> candidates;
  double sum = 0.0;
  std::size_t num_done = 0;
  for (std::size_t num_listed = 0; num_done < num_balls && num_listed < kMaxListed; ++num_done) {
    const std::size_t rank = spread_place(num_done, grid.num_points()), cell = grid.cell_at(rank);
    CellGrid::Walk(grid, cell).next(candidates);
    num_listed += candidates.size();
    const auto of_cell = grid.points_of(cell);
    sum += num_in_ball(cloud, candidates, cloud.points[of_cell[num_done % of_cell.size()]], radius_sq);
  }
  return num_done > 0 ? sum / static_cast<double>(num_done) : 0.0;
}

}  // namespace augicp
