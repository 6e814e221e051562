// SPDX-License-Identifier: MIT
#include "augicp/cloud/voxel_grid.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
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

std::uint64_t morton_key(const Vec3f& point, const Vec3f& min, double cell) {
  // Offsets from the minimum are never negative, so that truncation is the floor.
  const auto axis = [&](int k) {
    const double index = (static_cast<double>(point[k]) - static_cast<double>(min[k])) / cell;
    return spread_bits(static_cast<std::uint32_t>(static_cast<std::int32_t>(std::min(index, kMaxCells - 1.0))));
  };
  return axis(0) | axis(1) << 1 | axis(2) << 2;
}

struct Keyed {
  std::uint64_t key;
  std::uint32_t index;
  float x;  // of the point, by which most are told apart
};

// Sorted by some bits of the keys after others, the lowest first, which takes a fraction of the time that comparing
// them does. Bits above the highest key's, half of them in most clouds, are left out.
void sort_by_key(std::vector<Keyed>& keyed) {
  constexpr int kBits = 11, kKeyBits = 63;
  std::uint64_t all = 0;
  for (const Keyed& k : keyed) all |= k.key;
  std::vector<Keyed> sorted(keyed.size());
  for (int shift = 0; shift < kKeyBits && all >> shift != 0; shift += kBits) {
    const auto digit = [=](const Keyed& k) { return k.key >> shift & ((1 << kBits) - 1); };
    std::array<std::uint32_t, 1 << kBits> place{};
    for (const Keyed& k : keyed) ++place[digit(k)];
    std::exclusive_scan(place.begin(), place.end(), place.begin(), std::uint32_t{0});
    for (const Keyed& k : keyed) sorted[place[digit(k)]++] = k;
    keyed.swap(sorted);
  }
}

// By their keys, and where these are equal by their coordinates.
std::vector<Keyed> sorted_keys(const Cloud& cloud, const Vec3f& min, double cell) {
  std::vector<Keyed> keyed(cloud.size());
  for (std::uint32_t i = 0; i < keyed.size(); ++i) keyed[i] = {morton_key(cloud.points[i], min, cell), i, cloud.points[i].x()};
  sort_by_key(keyed);
  const auto is_before = [&](const Keyed& a, const Keyed& b) {
    if (a.x != b.x) return a.x < b.x;
    const Vec3f &p = cloud.points[a.index], &q = cloud.points[b.index];
    return std::tie(p.y(), p.z(), a.index) < std::tie(q.y(), q.z(), b.index);
  };
  for (auto begin = keyed.begin(), end = begin; begin != keyed.end(); begin = end) {
    end = std::find_if(begin, keyed.end(), [&](const Keyed& k) { return k.key != begin->key; });
    std::sort(begin, end, is_before);
  }
  return keyed;
}

double longest_side(const Bounds& box) { return (box.max.cast<double>() - box.min.cast<double>()).maxCoeff(); }

template <typename T>
std::vector<T> at(const std::vector<T>& values, const std::vector<std::uint32_t>& indices) {
  std::vector<T> chosen;
  chosen.reserve(indices.size());
  for (std::uint32_t i : indices) chosen.push_back(values[i]);
  return chosen;
}

// Of those that are known; NaN where none is.
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

std::vector<std::uint32_t> spatial_order(const Cloud& cloud) {
  if (cloud.empty()) return {};
  const Bounds box = bounds(cloud);
  const double cell = std::max(longest_side(box) / (kMaxCells - 1.0), 1e-30);
  const std::vector<Keyed> keyed = sorted_keys(cloud, box.min, cell);
  std::vector<std::uint32_t> order(keyed.size());
  std::transform(keyed.begin(), keyed.end(), order.begin(), [](const Keyed& k) { return k.index; });
  return order;
}

Cloud select(const Cloud& cloud, const std::vector<std::uint32_t>& indices) {
  Cloud chosen;
  chosen.origin = cloud.origin;
  chosen.viewpoint = cloud.viewpoint;
  chosen.points = at(cloud.points, indices);
  if (!cloud.weights.empty()) chosen.weights = at(cloud.weights, indices);
  if (cloud.has_intensities()) chosen.intensities = at(cloud.intensities, indices);
  if (cloud.has_intensity_gradients()) chosen.intensity_gradients = at(cloud.intensity_gradients, indices);
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
  require(longest_side(box) / voxel_size < kMaxCells, "voxel_size", voxel_size,
          "too small, the cloud spans more than 2^21 voxels");
  const std::vector<Keyed> keyed = sorted_keys(cloud, box.min, voxel_size);
  std::vector<std::uint32_t> nearest_to_mean;
  std::vector<Vec3f> means;
  std::vector<float> intensities;
  for (std::size_t begin = 0, end = 0; begin < keyed.size(); begin = end) {
    Vec3d sum = Vec3d::Zero();
    for (; end < keyed.size() && keyed[end].key == keyed[begin].key; ++end)
      sum += cloud.points[keyed[end].index].cast<double>();
    const Vec3f mean = (sum / static_cast<double>(end - begin)).cast<float>();
    const auto nearest = std::min_element(keyed.begin() + begin, keyed.begin() + end, [&](const Keyed& a, const Keyed& b) {
      return (cloud.points[a.index] - mean).squaredNorm() < (cloud.points[b.index] - mean).squaredNorm();
    });
    means.push_back(mean);
    if (cloud.has_intensities())
      intensities.push_back(mean_intensity(cloud, std::span(keyed).subspan(begin, end - begin)));
    nearest_to_mean.push_back(nearest->index);
  }
  Cloud sampled = select(cloud, nearest_to_mean);
  sampled.points = std::move(means);
  sampled.intensities = std::move(intensities);
  return sampled;
}

}  // namespace augicp
