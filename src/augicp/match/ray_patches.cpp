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
constexpr std::size_t kNumRays = 8000;                   // of all patches together
constexpr std::size_t kMaxPairs = std::size_t{1} << 22;  // of rays of a patch, which are compared with each other
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

// Each with each in a small patch. All points of a cloud that is far from the place lie in one patch: some of its rays,
// spread evenly over it, are then compared with all, so that the cost grows no faster than the number of points.
std::size_t num_compared(std::size_t num_rays) {
  return std::min(num_rays, std::max(kTypicalRays, kMaxPairs / std::max<std::size_t>(num_rays, 1)));
}

float spacing_at(std::size_t ray, const std::vector<Vec3f>& directions) {
  float nearest_sq = 4.0f;  // of the opposite direction
  for (std::size_t other = 0; other < directions.size(); ++other)
    if (other != ray) nearest_sq = std::min(nearest_sq, (directions[other] - directions[ray]).squaredNorm());
  return std::sqrt(nearest_sq);
}

void measure_spacing(RayPatch& patch) {
  std::vector<Vec3f> directions;
  for (const Vec3f& ray : patch.rays) directions.push_back(ray.normalized());
  const std::size_t count = num_compared(directions.size());
  for (std::size_t k = 0; k < count; ++k)
    patch.spacing.push_back(spacing_at(k * directions.size() / count, directions));
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
