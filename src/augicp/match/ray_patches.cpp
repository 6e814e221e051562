// SPDX-License-Identifier: MIT
#include "augicp/match/ray_patches.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <span>

#include "augicp/core/vectorized.h"
#include "augicp/match/cube_cells.h"

namespace augicp {
namespace {

// Rays of a patch: fewer tell no distribution, more cost their square.
constexpr std::size_t kMinRays = 16, kTypicalRays = 64;
constexpr std::size_t kNumRays = 8000;                   // of all patches together
constexpr std::size_t kMaxPairs = std::size_t{1} << 22;  // of rays of a patch, which are compared with each other
constexpr int kMinPatchesPerEdge = 8, kMaxPatchesPerEdge = 128;

constexpr std::uint32_t kNoCell = UINT32_MAX;

// cell_of(on_cube()) without branches.
AUGICP_INLINE std::uint32_t cell_towards(float x, float y, float z, std::int32_t cells_per_edge) {
  const float ax = std::abs(x), ay = std::abs(y), az = std::abs(z);
  const bool is_y = ay > ax, is_z = az > (is_y ? ay : ax), has_direction = x * x + (y * y + z * z) > 0.0f;
  const float longest = is_z ? z : is_y ? y : x, largest = has_direction ? std::abs(longest) : 1.0f;
  const float u = (is_z ? x : is_y ? z : y) / largest, v = (is_z ? y : is_y ? x : z) / largest;
  const std::int32_t axis = is_z ? 2 : is_y ? 1 : 0, face = longest < 0.0f ? axis + 3 : axis;
  const auto per_edge = static_cast<float>(cells_per_edge);
  const auto along = [=](float at) {
    const auto cell = static_cast<std::int32_t>((at + 1.0f) * 0.5f * per_edge);
    return cell < 0 ? 0 : cell < cells_per_edge ? cell : cells_per_edge - 1;
  };
  const std::int32_t cell = (face * cells_per_edge + along(v)) * cells_per_edge + along(u);
  return has_direction ? static_cast<std::uint32_t>(cell) : kNoCell;
}

AUGICP_VECTORIZED void write_cells(const Vec3f* points, std::size_t step, const Vec3f& place, int cells_per_edge,
                                   std::span<std::uint32_t> cells) {
  const float px = place.x(), py = place.y(), pz = place.z();
  std::uint32_t* const written = cells.data();
  for (std::size_t k = 0; k < cells.size(); ++k) {
    const float* const point = points[k * step].data();
    written[k] = cell_towards(point[0] - px, point[1] - py, point[2] - pz, cells_per_edge);
  }
}

// The cell of every step-th point; none for a point at the place.
std::vector<std::uint32_t> cells_of(const Cloud& cloud, const Vec3f& place, int cells_per_edge, std::size_t step = 1) {
  std::vector<std::uint32_t> cells((cloud.size() + step - 1) / step);
  write_cells(cloud.points.data(), step, place, cells_per_edge, cells);
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
  int cells = kMinPatchesPerEdge;
  for (; cells < kMaxPatchesPerEdge; cells *= 2) {
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

// Unit vectors, coordinate by coordinate.
struct Directions {
  std::vector<float> x, y, z;
};

Directions directions_of(const std::vector<Vec3f>& rays) {
  Directions directions;
  for (std::vector<float>* numbers : {&directions.x, &directions.y, &directions.z}) numbers->reserve(rays.size());
  for (const Vec3f& ray : rays) {
    const Vec3f direction = ray.normalized();
    directions.x.push_back(direction.x()), directions.y.push_back(direction.y()), directions.z.push_back(direction.z());
  }
  return directions;
}

// The least squared distance between a direction and those of a range.
constexpr std::size_t kLanes = 16;
AUGICP_VECTORIZED float nearest_sq(const Directions& directions, std::size_t ray, std::size_t begin, std::size_t end) {
  const float *x = directions.x.data(), *y = directions.y.data(), *z = directions.z.data();
  const float rx = x[ray], ry = y[ray], rz = z[ray];
  float least[kLanes];
  for (float& lane : least) lane = 4.0f;  // of the opposite direction
  std::size_t other = begin;
  for (; other + kLanes <= end; other += kLanes)
    for (std::size_t lane = 0; lane < kLanes; ++lane) {
      const float dx = x[other + lane] - rx, dy = y[other + lane] - ry, dz = z[other + lane] - rz;
      const float sq = dx * dx + (dy * dy + dz * dz);
      least[lane] = sq < least[lane] ? sq : least[lane];
    }
  for (std::size_t lane = 0; other < end; ++other, ++lane) {
    const float dx = x[other] - rx, dy = y[other] - ry, dz = z[other] - rz;
    least[lane] = std::min(least[lane], dx * dx + (dy * dy + dz * dz));
  }
  return *std::min_element(least, least + kLanes);
}

float spacing_at(std::size_t ray, const Directions& directions) {
  return std::sqrt(
      std::min(nearest_sq(directions, ray, 0, ray), nearest_sq(directions, ray, ray + 1, directions.x.size())));
}

void measure_spacing(RayPatch& patch) {
  const Directions directions = directions_of(patch.rays);
  const std::size_t num_rays = patch.rays.size(), count = num_compared(num_rays);
  for (std::size_t k = 0; k < count; ++k) patch.spacing.push_back(spacing_at(k * num_rays / count, directions));
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
