// SPDX-License-Identifier: MIT
#include "augicp/match/ray_spacing.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

#include "augicp/core/median.h"
#include "augicp/match/cube_cells.h"
#include "augicp/search/kd_tree.h"

namespace augicp {
namespace {

// Whole cells of directions are looked at, which leaves the spacing within them as it is: of 3 degrees, wide beside the
// steps of any sensor, and as many as have this number of points.
constexpr int kCellsPerEdge = 32;
constexpr std::size_t kNumKept = 8000, kMaxKept = 2 * kNumKept, kNumAsked = 2000;

constexpr double kLowQuantile = 0.02;

// Generated spinning LiDARs have 0.93 and more, a solid-state one 0.73, clouds of depth cameras 0.85. Fused fragments
// have up to 0.44. Scans of KITTI have 0.46, as their lines are not in step: their place is not known from the rays.
constexpr double kMinEvenness = 0.6;

// The cell of each direction; none for a point at the place.
constexpr std::uint16_t kNoCell = 0xffff;
std::vector<std::uint16_t> cells_of(const Cloud& cloud, const Vec3f& place) {
  std::vector<std::uint16_t> cells(cloud.size(), kNoCell);
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    const Vec3f ray = cloud.points[i] - place;
    if (ray.squaredNorm() > 0.0f) cells[i] = static_cast<std::uint16_t>(cell_of(on_cube(ray), kCellsPerEdge));
  }
  return cells;
}

// Cells that have points, spread evenly over all of them.
std::vector<char> chosen_cells(const std::vector<std::uint16_t>& cells) {
  std::vector<char> is_chosen(num_cube_cells(kCellsPerEdge));
  for (const std::uint16_t cell : cells)
    if (cell != kNoCell) is_chosen[cell] = 1;
  const std::size_t step = (cells.size() + kNumKept - 1) / kNumKept;
  std::size_t num_occupied = 0;
  for (char& one : is_chosen)
    if (one) one = num_occupied++ % step == 0;
  return is_chosen;
}

// Unit directions as points, in the order of the cloud, which is mostly that of the sensor's rays.
Cloud directions(const Cloud& cloud, const Vec3f& place) {
  const std::vector<std::uint16_t> cells = cells_of(cloud, place);
  const std::vector<char> is_chosen = chosen_cells(cells);
  Cloud kept;
  for (std::size_t i = 0; i < cloud.size() && kept.size() < kMaxKept; ++i)
    if (cells[i] != kNoCell && is_chosen[cells[i]]) kept.points.push_back((cloud.points[i] - place).normalized());
  return kept;
}

}  // namespace

double evenness_of_rays(const Cloud& cloud, const Vec3f& place) {
  const Cloud seen = directions(cloud, place);
  if (seen.size() < 2) return 0.0;
  const KdTree tree(seen);
  const std::size_t step = (seen.size() + kNumAsked - 1) / kNumAsked;
  std::vector<float> angles;
  for (std::size_t i = 0; i < seen.size(); i += step)
    angles.push_back(std::sqrt(tree.nearest_k(seen.points[i], 2).back().distance_sq));
  const auto low = static_cast<std::size_t>(kLowQuantile * static_cast<double>(angles.size()));
  const float median = upper_median(angles);
  return median > 0.0f ? static_cast<double>(value_at_rank(std::move(angles), low) / median) : 0.0;
}

bool is_one_sensors_scan(const Cloud& cloud) { return evenness_of_rays(cloud, assumed_place(cloud)) >= kMinEvenness; }

}  // namespace augicp
