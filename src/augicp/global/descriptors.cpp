// SPDX-License-Identifier: MIT
#include "augicp/global/descriptors.h"

#include <algorithm>
#include <functional>

#include "augicp/cloud/voxel_grid.h"
#include "augicp/core/parallel.h"
#include "augicp/global/pair_histogram.h"

namespace augicp {
namespace {

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

// The key points, and the points around each in a cloud.
struct Asked {
  ExtendedPoints points;
  std::function<std::span<const std::uint32_t>(std::size_t)> around;
  std::span<const std::uint32_t> in_cloud;  // their own indices; empty if they are not of the cloud
};

// Which points of the cloud are around a key point.
std::vector<bool> is_around(const Asked& asked, std::size_t cloud_size) {
  std::vector<bool> is_asked(cloud_size, false);
  for (std::size_t i = 0; i < asked.points.points.size(); ++i)
    for (const std::uint32_t j : asked.around(i)) is_asked[j] = true;
  return is_asked;
}

// Of those points of a cloud: with the points around each.
std::vector<PairHistogram> simple_histograms(const KeyCloud& cloud, const std::vector<bool>& is_asked,
                                             int num_threads) {
  const ExtendedPoints all{cloud.points, cloud.normals};
  std::vector<PairHistogram> histograms(cloud.size());
  const auto count = [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
      if (is_asked[i]) histograms[i] = pair_histogram(all[i], all, cloud.balls.around(i), cloud.has_signs());
  };
  for_each_block(histograms.size(), num_threads, count, kPointsPerBlock);
  return histograms;
}

// Of each key point: its own histogram, averaged with the histograms of the points around it.
std::vector<PairHistogram> fast_histograms(const Asked& asked, const KeyCloud& cloud, int num_threads) {
  const std::size_t num_asked = asked.points.points.size();
  const ExtendedPoints all{cloud.points, cloud.normals};
  const SidedHistograms theirs(simple_histograms(cloud, is_around(asked, cloud.size()), num_threads));
  std::vector<PairHistogram> histograms(num_asked);
  const auto add = [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const ExtendedPoint point = asked.points[i];
      const bool is_known = !asked.in_cloud.empty();
      histograms[i] =
          is_known ? theirs.same[asked.in_cloud[i]] : pair_histogram(point, all, asked.around(i), cloud.has_signs());
      histograms[i] += mean_around(point, all, theirs, asked.around(i), cloud.has_signs());
    }
  };
  for_each_block(num_asked, num_threads, add, kPointsPerBlock);
  return histograms;
}

}  // namespace

KeyPoints described(const KeyCloud& cloud, std::size_t max_count, int num_threads) {
  KeyPoints keys;
  const std::vector<std::uint32_t> chosen = most_varied(cloud, max_count);
  for (const std::uint32_t i : chosen) {
    keys.points.push_back(cloud.points[i]);
    keys.normals.push_back(cloud.normals[i]);
  }
  const ExtendedPoints of{keys.points, keys.normals};
  const auto small =
      fast_histograms({of, [&](std::size_t i) { return cloud.balls.around(chosen[i]); }, chosen}, cloud, num_threads);
  const KeyCloud coarse = coarser(cloud, num_threads);
  const BallLists lists(keys.points, coarse.points, kBallVoxels * coarse.voxel_size, num_threads);
  const auto large = fast_histograms({of, [&](std::size_t i) { return lists.around(i); }, {}}, coarse, num_threads);
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
