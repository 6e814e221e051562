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

#include "augicp/cloud/voxel_cells.h"
#include "augicp/cloud/voxel_means.h"
#include "augicp/core/check.h"

namespace augicp {
namespace {

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

SortedPoints by_voxel(const Cloud& cloud, const VoxelCells& cells) {
  SortedPoints sorted(cloud.size());
  for (std::uint32_t i = 0; i < cloud.size(); ++i) sorted.points[i] = {morton_key(cells.parts(cloud.points[i])), i};
  sort_by_key(sorted);
  return sorted;
}

template <typename T>
std::vector<T> at(const std::vector<T>& values, const std::vector<std::uint32_t>& indices) {
  std::vector<T> chosen;
  chosen.reserve(indices.size());
  for (std::uint32_t i : indices) chosen.push_back(values[i]);
  return chosen;
}

Vec3f mean_point(const Cloud& cloud, const VoxelCells& cells, std::span<const Keyed> voxel) {
  if (voxel.size() == 1) return cloud.points[voxel.front().index];
  Parts sum{};  // from the corner of the voxel
  for (const Keyed& point : voxel) {
    const Parts parts = cells.parts(cloud.points[point.index]);
    for (int k = 0; k < 3; ++k) sum[k] += parts[k] % kParts;
  }
  const Parts any = cells.parts(cloud.points[voxel.front().index]);
  Vec3d mean;
  for (int k = 0; k < 3; ++k)
    mean[k] =
        static_cast<double>(any[k] - any[k] % kParts) + static_cast<double>(sum[k]) / static_cast<double>(voxel.size());
  return cells.place(mean).cast<float>();
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
  const VoxelCells cells = voxel_cells(cloud, voxel_size);
  const bool has_more =
      cloud.has_directions() || cloud.has_gaussians() || cloud.has_intensities() || !cloud.weights.empty();
  if (!has_more) {
    if (auto few = few_voxel_means(cloud, cells)) {
      Cloud sampled = select(cloud, {});
      sampled.points = std::move(*few);
      return sampled;
    }
  }
  SortedPoints sorted = by_voxel(cloud, cells);
  std::vector<std::uint32_t> nearest;
  std::vector<Vec3f> means;
  std::vector<float> intensities;
  for (auto begin = sorted.points.begin(), end = begin; begin != sorted.points.end(); begin = end) {
    end = std::find_if(begin, sorted.points.end(), [&](const Keyed& k) { return k.key != begin->key; });
    const std::span<Keyed> voxel(begin, end);
    means.push_back(mean_point(cloud, cells, voxel));
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
