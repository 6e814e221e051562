// SPDX-License-Identifier: MIT
#include "augicp/cloud/voxel_grid.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <numeric>
#include <span>
#include <tuple>

#include "augicp/core/check.h"

namespace augicp {
namespace {

constexpr double kMaxCells = 1 << 21;  // three axes of 21 bits fit one 64-bit key

// Every third bit of the result is a bit of the lowest 21 of x.
std::uint64_t spread_bits(std::uint64_t x) {
  x = (x | x << 32) & 0x001f00000000ffff;
  x = (x | x << 16) & 0x001f0000ff0000ff;
  x = (x | x << 8) & 0x100f00f00f00f00f;
  x = (x | x << 4) & 0x10c30c30c30c30c3;
  return (x | x << 2) & 0x1249249249249249;
}

// Positions in whole parts of a cell from the corner of the grid. The sum of integers does not depend on their order.
constexpr int kPartBits = 30;
constexpr std::int64_t kParts = std::int64_t{1} << kPartBits;
using Parts = std::array<std::int64_t, 3>;

class Grid {
 public:
  Grid(const Vec3f& min, double cell)
      : min_(min.cast<double>()), parts_per_metre_(std::min(kParts / cell, std::numeric_limits<double>::max())) {}

  Parts parts(const Vec3f& point) const {
    // Offsets from the minimum are never negative, so truncation equals floor.
    const auto axis = [&](int k) {
      const double parts = (static_cast<double>(point[k]) - min_[k]) * parts_per_metre_;
      return static_cast<std::int64_t>(std::min(parts, kMaxCells * kParts - 1.0));
    };
    return {axis(0), axis(1), axis(2)};
  }
  Vec3d place(const Vec3d& parts) const { return min_ + parts / parts_per_metre_; }

 private:
  Vec3d min_;
  double parts_per_metre_;
};

std::uint64_t morton_key(const Parts& parts) {
  const auto axis = [&](int k) { return spread_bits(static_cast<std::uint64_t>(parts[k] >> kPartBits)); };
  return axis(0) | axis(1) << 1 | axis(2) << 2;
}

struct Keyed {
  std::uint64_t key;
  std::uint32_t index;
};

// Room for all points twice, to sort from one half to the other. One allocation: when freed, glibc keeps it for the
// next cloud. Two of half the size would go back to the system, which clears new pages.
struct SortedPoints {
  explicit SortedPoints(std::size_t count)
      : memory(std::make_unique_for_overwrite<Keyed[]>(2 * count)),
        points(memory.get(), count),
        spare(memory.get() + count, count) {}
  std::unique_ptr<Keyed[]> memory;
  std::span<Keyed> points, spare;
};

// Radix sort, lowest bits first; faster than comparing. Bits above the highest key's, half of them in most clouds, are
// skipped.
void sort_by_key(SortedPoints& sorted) {
  constexpr int kBits = 11, kKeyBits = 63;
  std::uint64_t all = 0;
  for (const Keyed& k : sorted.points) all |= k.key;
  for (int shift = 0; shift < kKeyBits && all >> shift != 0; shift += kBits) {
    const auto digit = [=](const Keyed& k) { return k.key >> shift & ((1 << kBits) - 1); };
    std::array<std::uint32_t, 1 << kBits> place{};
    for (const Keyed& k : sorted.points) ++place[digit(k)];
    std::exclusive_scan(place.begin(), place.end(), place.begin(), std::uint32_t{0});
    for (const Keyed& k : sorted.points) sorted.spare[place[digit(k)]++] = k;
    std::swap(sorted.points, sorted.spare);
  }
}

SortedPoints by_voxel(const Cloud& cloud, const Grid& grid) {
  SortedPoints sorted(cloud.size());
  for (std::uint32_t i = 0; i < cloud.size(); ++i) sorted.points[i] = {morton_key(grid.parts(cloud.points[i])), i};
  sort_by_key(sorted);
  return sorted;
}

double longest_side(const Bounds& box) { return (box.max.cast<double>() - box.min.cast<double>()).maxCoeff(); }

template <typename T>
std::vector<T> at(const std::vector<T>& values, const std::vector<std::uint32_t>& indices) {
  std::vector<T> chosen;
  chosen.reserve(indices.size());
  for (std::uint32_t i : indices) chosen.push_back(values[i]);
  return chosen;
}

Vec3f mean_point(const Cloud& cloud, const Grid& grid, std::span<const Keyed> voxel) {
  if (voxel.size() == 1) return cloud.points[voxel.front().index];
  Parts sum{};  // from the corner of the voxel
  for (const Keyed& point : voxel) {
    const Parts parts = grid.parts(cloud.points[point.index]);
    for (int k = 0; k < 3; ++k) sum[k] += parts[k] % kParts;
  }
  const Parts any = grid.parts(cloud.points[voxel.front().index]);
  Vec3d mean;
  for (int k = 0; k < 3; ++k)
    mean[k] =
        static_cast<double>(any[k] - any[k] % kParts) + static_cast<double>(sum[k]) / static_cast<double>(voxel.size());
  return grid.place(mean).cast<float>();
}

void sort_by_coordinates(const Cloud& cloud, std::span<Keyed> voxel) {
  std::sort(voxel.begin(), voxel.end(), [&](const Keyed& a, const Keyed& b) {
    const Vec3f &p = cloud.points[a.index], &q = cloud.points[b.index];
    return std::tie(p.x(), p.y(), p.z(), a.index) < std::tie(q.x(), q.y(), q.z(), b.index);
  });
}

// The first of the nearest ones.
std::uint32_t nearest_to(const Vec3f& place, const Cloud& cloud, std::span<const Keyed> voxel) {
  const auto distance_sq = [&](const Keyed& k) { return (cloud.points[k.index] - place).squaredNorm(); };
  const auto is_nearer = [&](const Keyed& a, const Keyed& b) { return distance_sq(a) < distance_sq(b); };
  return std::min_element(voxel.begin(), voxel.end(), is_nearer)->index;
}

// Mean of the known intensities; NaN if none is known.
float mean_intensity(const Cloud& cloud, std::span<const Keyed> voxel) {
  double sum = 0.0;
  int count = 0;
  for (const Keyed& point : voxel) {
    const float intensity = cloud.intensities[point.index];
    if (std::isnan(intensity)) continue;
    sum += static_cast<double>(intensity);
    ++count;
  }
  return count == 0 ? std::numeric_limits<float>::quiet_NaN() : static_cast<float>(sum / count);
}

}  // namespace

Cloud select(const Cloud& cloud, const std::vector<std::uint32_t>& indices) {
  Cloud chosen;
  chosen.origin = cloud.origin;
  chosen.viewpoint = cloud.viewpoint;
  chosen.points = at(cloud.points, indices);
  if (!cloud.weights.empty()) chosen.weights = at(cloud.weights, indices);
  if (cloud.has_intensities()) chosen.intensities = at(cloud.intensities, indices);
  if (cloud.has_intensity_gradients()) chosen.intensity_gradients = at(cloud.intensity_gradients, indices);
  if (cloud.has_gaussians()) chosen.gaussians = at(cloud.gaussians, indices);
  if (!cloud.has_directions()) return chosen;
  chosen.directions = at(cloud.directions, indices);
  chosen.structures = at(cloud.structures, indices);
  return chosen;
}

Cloud evenly_chosen(const Cloud& cloud, std::size_t max_count) {
  const std::size_t step = (cloud.size() + max_count - 1) / max_count;
  if (step <= 1) return cloud;
  std::vector<std::uint32_t> chosen;
  for (std::size_t i = 0; i < cloud.size(); i += step) chosen.push_back(static_cast<std::uint32_t>(i));
  return select(cloud, chosen);
}

Cloud downsample(const Cloud& cloud, double voxel_size) {
  require_positive("voxel_size", voxel_size);
  if (cloud.empty()) return cloud;
  const Bounds box = bounds(cloud);
  const double longest = longest_side(box);
  require(longest / voxel_size < kMaxCells, "voxel_size", voxel_size,
          "too small, the cloud spans more than 2^21 voxels");
  // A cell larger than the cloud is not needed, and its parts would be too coarse for the cloud.
  const Grid grid(box.min, longest > 0.0 ? std::min(voxel_size, 2.0 * longest) : voxel_size);
  const bool has_more =
      cloud.has_directions() || cloud.has_gaussians() || cloud.has_intensities() || !cloud.weights.empty();
  SortedPoints sorted = by_voxel(cloud, grid);
  std::vector<std::uint32_t> nearest;
  std::vector<Vec3f> means;
  std::vector<float> intensities;
  for (auto begin = sorted.points.begin(), end = begin; begin != sorted.points.end(); begin = end) {
    end = std::find_if(begin, sorted.points.end(), [&](const Keyed& k) { return k.key != begin->key; });
    const std::span<Keyed> voxel(begin, end);
    means.push_back(mean_point(cloud, grid, voxel));
    if (!has_more) continue;
    sort_by_coordinates(cloud, voxel);  // the first point must not depend on the order of the input
    nearest.push_back(nearest_to(means.back(), cloud, voxel));
    if (cloud.has_intensities()) intensities.push_back(mean_intensity(cloud, voxel));
  }
  Cloud sampled = select(cloud, nearest);
  sampled.points = std::move(means);
  sampled.intensities = std::move(intensities);
  return sampled;
}

}  // namespace augicp
