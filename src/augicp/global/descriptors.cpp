// SPDX-License-Identifier: MIT
#include "augicp/global/descriptors.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "augicp/cloud/voxel_grid.h"
#include "augicp/core/parallel.h"
#include "augicp/global/pair_histogram.h"

namespace augicp {
namespace {

constexpr double kRadiusVoxels = 5.0;
constexpr double kCoarser = 2.0;  // the large ball is of the same cloud with voxels of twice the size
constexpr std::size_t kPointsPerBlock = 128;

KeyCloud coarser(const KeyCloud& cloud, int num_threads) {
  Cloud points;
  points.points = cloud.points;
  return key_cloud(points, kCoarser * cloud.voxel_size, cloud.viewpoint, num_threads);
}

std::vector<std::uint32_t> most_varied(const KeyCloud& cloud, std::size_t max_count) {
  std::vector<std::uint32_t> chosen;
  for (std::uint32_t i = 0; i < cloud.size(); ++i)
    if (!cloud.normals[i].isZero()) chosen.push_back(i);
  if (chosen.size() <= max_count) return chosen;
  std::stable_sort(chosen.begin(), chosen.end(),
                   [&](std::uint32_t a, std::uint32_t b) { return cloud.variation[a] > cloud.variation[b]; });
  chosen.resize(max_count);
  std::sort(chosen.begin(), chosen.end());
  return chosen;
}

std::vector<PairHistogram> simple_histograms(const ExtendedPoints& of, const ExtendedPoints& support,
                                             const BallLists& balls, bool has_signs, int num_threads) {
  std::vector<PairHistogram> histograms(of.points.size());
  const auto count = [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
      histograms[i] = pair_histogram({of.points[i], of.normals[i]}, support, balls.around(i), has_signs);
  };
  for_each_block(histograms.size(), num_threads, count, kPointsPerBlock);
  return histograms;
}

// Of each point: its own histogram, averaged with the histograms of the points around it.
std::vector<PairHistogram> fast_histograms(const ExtendedPoints& of, const KeyCloud& support, int num_threads) {
  const double radius = kRadiusVoxels * support.voxel_size;
  const ExtendedPoints around{support.points, support.normals};
  const BallLists of_support(support.points, support.points, radius, num_threads);
  const auto theirs = simple_histograms(around, around, of_support, support.has_signs(), num_threads);
  const BallLists balls(of.points, support.points, radius, num_threads);
  auto histograms = simple_histograms(of, around, balls, support.has_signs(), num_threads);
  const auto add = [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
      histograms[i] += mean_around({of.points[i], of.normals[i]}, around, theirs, balls.around(i), support.has_signs());
  };
  for_each_block(histograms.size(), num_threads, add, kPointsPerBlock);
  return histograms;
}

}  // namespace

KeyPoints described(const KeyCloud& cloud, std::size_t max_count, int num_threads) {
  KeyPoints keys;
  for (const std::uint32_t i : most_varied(cloud, max_count)) {
    keys.points.push_back(cloud.points[i]);
    keys.normals.push_back(cloud.normals[i]);
  }
  const ExtendedPoints of{keys.points, keys.normals};
  const auto small = fast_histograms(of, cloud, num_threads),
             large = fast_histograms(of, coarser(cloud, num_threads), num_threads);
  keys.descriptors.resize(keys.size());
  for (std::size_t i = 0; i < keys.size(); ++i) {
    PairHistogram balls[kBalls] = {small[i], large[i]};
    if (!cloud.has_signs() && balls[0].bend() + balls[1].bend() > 0.0f) {
      for (PairHistogram& ball : balls) ball = opposite(ball);
      keys.normals[i] = -keys.normals[i];
    }
    for (std::size_t k = 0; k < kBalls; ++k) balls[k].write_roots(keys.descriptors[i].data() + k * kBins * kHistograms);
  }
  return keys;
}

}  // namespace augicp
