// SPDX-License-Identifier: MIT
#include "augicp/registration/lengths.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>
#include <vector>

#include "augicp/core/median.h"
#include "augicp/core/parallel.h"

namespace augicp {
namespace {

constexpr double kExtentQuantile = 0.8;
constexpr double kViewWidth = 1.2;

// A view of a desk from 1.2 m then has balls of 5 cm, which experiments on fr1/desk favour, and a gate of 0.36 m; other
// scenes scale with it. A ball of four voxels has about 50 points of a plane; with three the car scans lose a third of
// their accuracy.
constexpr double kRadiusPerExtent = 1.0 / 30.0;
constexpr double kVoxelPerRadius = 1.0 / 4.0;
constexpr double kGatePerExtent = 1.0 / 4.0;

// Of so many values a sample tells between which two a rank lies.
constexpr std::size_t kSampleSize = 512, kMinValues = 8 * kSampleSize;
constexpr std::size_t kSampleMargin = 48;  // four standard deviations of a sample's median and more

struct Bracket {
  float low, high;
};

// Two values between which the value at a rank most likely lies.
Bracket likely_bracket(const std::vector<float>& values, std::size_t rank) {
  std::vector<float> sample(kSampleSize);
  for (std::size_t k = 0; k < kSampleSize; ++k) sample[k] = values[k * values.size() / kSampleSize];
  std::sort(sample.begin(), sample.end());
  const std::size_t place = rank * kSampleSize / values.size();
  return {sample[place - std::min(place, kSampleMargin)], sample[std::min(place + kSampleMargin, kSampleSize - 1)]};
}

// Selecting within a bracket takes a fraction of the time of selecting among all values. REQUIRES: no value is NaN.
float quantile(const std::vector<float>& values, double share) {
  const auto rank = static_cast<std::size_t>(share * static_cast<double>(values.size() - 1));
  if (values.size() < kMinValues) return value_at_rank(values, rank);
  const auto [low, high] = likely_bracket(values, rank);
  const auto within = std::make_unique_for_overwrite<float[]>(values.size());
  std::size_t num_below = 0, num_within = 0;
  for (const float value : values) {  // no branch: it would be unpredictable
    within[num_within] = value;
    num_below += value < low ? 1 : 0;
    num_within += value >= low && value <= high ? 1 : 0;
  }
  if (rank < num_below || rank >= num_below + num_within) return value_at_rank(values, rank);
  return value_at_rank(std::vector<float>(within.get(), within.get() + num_within), rank - num_below);
}

std::vector<float> distances_from(const Vec3f& centre, const Cloud& cloud) {
  std::vector<float> distances(cloud.size());
  for (std::size_t i = 0; i < cloud.size(); ++i) distances[i] = (cloud.points[i] - centre).norm();
  return distances;
}

}  // namespace

Vec3f median_point(const Cloud& cloud) {
  Vec3f median;
  std::vector<float> coordinate(cloud.size());
  for (int axis = 0; axis < 3; ++axis) {
    for (std::size_t i = 0; i < cloud.size(); ++i) coordinate[i] = cloud.points[i][axis];
    median[axis] = quantile(coordinate, 0.5);
  }
  return median;
}

double voxel_size_for(double radius) { return kVoxelPerRadius * radius; }

double feasible_voxel(const Cloud& cloud, double voxel_size) {
  constexpr double kCells = 1 << 20;
  return std::max(voxel_size, bounds(cloud).diagonal() / kCells);
}

double robust_extent(const Scan& scan) {
  if (scan.cloud.empty()) return 0.0;
  if (scan.view) return kViewWidth * static_cast<double>(quantile(distances_from(Vec3f::Zero(), scan.cloud), 0.5));
  const Vec3f centre = median_point(scan.cloud);
  return 2.0 * static_cast<double>(quantile(distances_from(centre, scan.cloud), kExtentQuantile));
}

Lengths finer_lengths(Lengths lengths, double share) {
  lengths.radius *= share;
  lengths.voxel_size *= share;
  return lengths;
}

Lengths derive_lengths(const Scan& source, const Scan& target, int num_threads) {
  const auto [of_source, of_target] = both(
      num_threads, [&] { return robust_extent(source); }, [&] { return robust_extent(target); });
  Lengths lengths;
  lengths.extent = std::sqrt(of_source * of_target);
  lengths.radius = kRadiusPerExtent * lengths.extent;
  lengths.voxel_size = voxel_size_for(lengths.radius);
  lengths.max_distance = kGatePerExtent * lengths.extent;
  return lengths;
}

}  // namespace augicp
