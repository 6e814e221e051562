// SPDX-License-Identifier: MIT
#include "augicp/match/ray_patches.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "augicp/match/cube_cells.h"

namespace augicp {
namespace {

// Rays of a patch: fewer tell no distribution, more cost their square.
constexpr std::size_t kMinRays = 16, kTypicalRays = 64;
constexpr std::size_t kNumRays = 8000;  // of all patches together
constexpr int kMinCellsPerEdge = 8, kMaxCellsPerEdge = 128;

constexpr std::uint32_t kNoCell = UINT32_MAX;

// The cell of every step-th point; none for a point at the place.
std::vector<std::uint32_t> cells_of(const Cloud& cloud, const Vec3f& place, int cells_per_edge, std::size_t step = 1) {
  std::vector<std::uint32_t> cells;
  cells.reserve(cloud.size() / step + 1);
  for (std::size_t i = 0; i < cloud.size(); i += step) {
    const Vec3f ray = cloud.points[i] - place;
    const bool has_direction = ray.squaredNorm() > 0.0f;
    cells.push_back(has_direction ? static_cast<std::uint32_t>(cell_of(on_cube(ray), cells_per_edge)) : kNoCell);
  }
  return cells;
}

std::vector<std::uint32_t> counts_of(const std::vector<std::uint32_t>& cells, int cells_per_edge) {
  std::vector<std::uint32_t> counts(num_cube_cells(cells_per_edge));
  for (const std::uint32_t cell : cells)
    if (cell != kNoCell) ++counts[cell];
  return counts;
}

// As fine as leaves the typical number of points in a cell. Some of the points tell which cells have any.
int cells_for(const Cloud& cloud, const Vec3f& place) {
  const std::size_t step = cloud.size() / kNumRays + 1;
  int cells = kMinCellsPerEdge;
  for (; cells < kMaxCellsPerEdge; cells *= 2) {
    const std::vector<std::uint32_t> counts = counts_of(cells_of(cloud, place, cells, step), cells);
    const auto num_empty = static_cast<std::size_t>(std::count(counts.begin(), counts.end(), 0U));
    if (cloud.size() < 2 * kTypicalRays * (counts.size() - num_empty)) break;
  }
  return cells;
}

// The patch of each cell, for cells chosen evenly over all that have enough points; kNoCell for the others.
std::vector<std::uint32_t> chosen(const std::vector<std::uint32_t>& counts, std::size_t& num_patches) {
  std::size_t num_points = 0;
  for (const std::uint32_t count : counts)
    if (count >= kMinRays) num_points += count;
  const std::size_t step = num_points / kNumRays + 1;
  std::vector<std::uint32_t> patches(counts.size(), kNoCell);
  std::size_t num_full = 0;
  for (std::size_t cell = 0; cell < counts.size(); ++cell)
    if (counts[cell] >= kMinRays && num_full++ % step == 0) patches[cell] = static_cast<std::uint32_t>(num_patches++);
  return patches;
}

// Each with each: a patch is small.
void measure_spacing(RayPatch& patch) {
  std::vector<Vec3f> directions;
  for (const Vec3f& ray : patch.rays) directions.push_back(ray.normalized());
  for (const Vec3f& one : directions) {
    float nearest_sq = 4.0f;  // of the opposite direction
    for (const Vec3f& other : directions)
      if (&other != &one) nearest_sq = std::min(nearest_sq, (other - one).squaredNorm());
    patch.spacing.push_back(std::sqrt(nearest_sq));
  }
}

}  // namespace

std::vector<RayPatch> ray_patches(const Cloud& cloud, const Vec3f& place) {
  const int cells_per_edge = cells_for(cloud, place);
  const std::vector<std::uint32_t> cells = cells_of(cloud, place, cells_per_edge);
  std::size_t num_patches = 0;
  const std::vector<std::uint32_t> patch_of = chosen(counts_of(cells, cells_per_edge), num_patches);
  std::vector<RayPatch> patches(num_patches);
  for (std::size_t i = 0; i < cells.size(); ++i)
    if (cells[i] != kNoCell && patch_of[cells[i]] != kNoCell)
      patches[patch_of[cells[i]]].rays.push_back(cloud.points[i] - place);
  for (RayPatch& patch : patches) measure_spacing(patch);
  return patches;
}

}  // namespace augicp
