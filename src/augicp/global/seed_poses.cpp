// SPDX-License-Identifier: MIT
#include "augicp/global/seed_poses.h"

#include <Eigen/SVD>
#include <algorithm>
#include <numeric>

#include "augicp/core/parallel.h"
#include "augicp/global/pair_columns.h"

namespace augicp {
namespace {

constexpr std::size_t kMostCommon = 16;    // correspondences of a seed's first pose, beside itself
constexpr std::size_t kMinConsistent = 3;  // fewer say nothing
constexpr int kRefits = 2;

// Seeds are tried in batches, those that are consistent with most others first. What supports the pose of a batch is no
// seed of a later one: a large group costs no more than a small one.
constexpr std::size_t kSeedsPerBatch = 32, kMaxSeeds = 512, kSeedsPerBlock = 2;

constexpr std::size_t kRowsPerBlock = 64;

// The inputs of all that follows.
struct Clues {
  const KeyPoints& source;
  const KeyPoints& target;
  std::span<const Correspondence> pairs;
  const ConsistencyGraph& graph;
  const SeedOptions& options;
  PairColumns columns;
};

// A correspondence with those that share the most others with it; empty if it is consistent with too few.
std::vector<Correspondence> group_of(std::uint32_t seed, const Clues& clues) {
  std::vector<std::pair<int, std::uint32_t>> common;
  for (const std::uint32_t other : clues.graph.consistent_with(seed))
    common.emplace_back(-clues.graph.num_common(seed, other), other);
  if (common.size() < kMinConsistent) return {};
  const std::size_t count = std::min(kMostCommon, common.size());
  std::partial_sort(common.begin(), common.begin() + static_cast<std::ptrdiff_t>(count), common.end());
  std::vector<Correspondence> group{clues.pairs[seed]};
  for (std::size_t k = 0; k < count; ++k) group.push_back(clues.pairs[common[k].second]);
  return group;
}

// All correspondences, those that are consistent with most others first.
std::vector<std::uint32_t> in_order(const ConsistencyGraph& graph, int num_threads) {
  std::vector<int> count(graph.size());
  const auto add_up = [&](std::size_t begin, std::size_t end) {
    for (std::size_t a = begin; a < end; ++a) count[a] = graph.num_common(a, a);
  };
  for_each_block(count.size(), num_threads, add_up, kRowsPerBlock);
  std::vector<std::uint32_t> order(graph.size());
  std::iota(order.begin(), order.end(), 0u);
  std::stable_sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) { return count[a] > count[b]; });
  return order;
}

// The pose of a seed, and what supports it; nothing if too little does.
struct Grown {
  Rigid3 pose;
  std::vector<std::uint32_t> support;
};
Grown grown(std::uint32_t seed, const Clues& clues) {
  std::vector<Correspondence> group = group_of(seed, clues);
  Grown result;
  if (group.empty()) return result;
  for (int k = 0; k <= kRefits; ++k) {
    result.pose = fitted_pose(clues.source, clues.target, group, clues.options.lever);
    result.support = clues.columns.supporting(result.pose, clues.options.distance, clues.options.cosine);
    if (result.support.size() < kMinConsistent) return {};
    group.clear();
    for (const std::uint32_t index : result.support) group.push_back(clues.pairs[index]);
  }
  return result;
}

std::vector<SeedPose> poses_of_seeds(const Clues& clues, int num_threads) {
  const std::vector<std::uint32_t> order = in_order(clues.graph, num_threads);
  std::vector<bool> is_used(order.size());
  std::vector<SeedPose> poses;
  std::size_t at = 0;
  for (std::size_t tried = 0; tried < kMaxSeeds && at < order.size(); tried += kSeedsPerBatch) {
    std::vector<std::uint32_t> batch;
    for (; at < order.size() && batch.size() < kSeedsPerBatch; ++at)
      if (!is_used[order[at]]) batch.push_back(order[at]);
    std::vector<Grown> found(batch.size());
    const auto grow = [&](std::size_t begin, std::size_t end) {
      for (std::size_t k = begin; k < end; ++k) found[k] = grown(batch[k], clues);
    };
    for_each_block(batch.size(), num_threads, grow, kSeedsPerBlock);
    for (const Grown& seed : found) {
      for (const std::uint32_t index : seed.support) is_used[index] = true;
      if (!seed.support.empty()) poses.push_back({seed.pose, static_cast<double>(seed.support.size())});
    }
  }
  return poses;
}

// The first of those that are one, best supported first.
std::vector<SeedPose> distinct(std::vector<SeedPose> poses, const Vec3d& centre, const SeedOptions& options) {
  std::stable_sort(poses.begin(), poses.end(),
                   [](const SeedPose& a, const SeedPose& b) { return a.support > b.support; });
  std::vector<SeedPose> kept;
  for (const SeedPose& pose : poses) {
    if (kept.size() == options.max_count) break;
    const Rigid3& a = pose.target_from_source;
    const bool is_known = std::any_of(kept.begin(), kept.end(), [&](const SeedPose& other) {
      const Rigid3& b = other.target_from_source;
      return (a * centre - b * centre).norm() < options.same_distance && angle_between(a, b) < options.same_angle_rad;
    });
    if (!is_known) kept.push_back(pose);
  }
  return kept;
}

Vec3d mean_point(const KeyPoints& keys) {
  Vec3d sum = Vec3d::Zero();
  for (const Vec3f& point : keys.points) sum += point.cast<double>();
  return sum / std::max(1.0, static_cast<double>(keys.size()));
}

}  // namespace

Rigid3 fitted_pose(const KeyPoints& source, const KeyPoints& target, std::span<const Correspondence> pairs,
                   double lever) {
  Vec3d from = Vec3d::Zero(), to = Vec3d::Zero();
  for (const Correspondence& pair : pairs) {
    from += source.points[pair.source].cast<double>();
    to += target.points[pair.target].cast<double>();
  }
  from /= static_cast<double>(pairs.size());
  to /= static_cast<double>(pairs.size());
  Mat3d sum = Mat3d::Zero();
  for (const Correspondence& pair : pairs) {
    sum += (target.points[pair.target].cast<double>() - to) *
           (source.points[pair.source].cast<double>() - from).transpose();
    sum += lever * lever * target.normals[pair.target].cast<double>() *
           source.normals[pair.source].cast<double>().transpose();
  }
  const Eigen::JacobiSVD<Mat3d> svd(sum, Eigen::ComputeFullU | Eigen::ComputeFullV);
  Vec3d signs = Vec3d::Ones();
  if (svd.matrixU().determinant() * svd.matrixV().determinant() < 0.0) signs.z() = -1.0;
  Rigid3 pose;
  pose.rotation =
      Eigen::Quaterniond(Mat3d(svd.matrixU() * signs.asDiagonal() * svd.matrixV().transpose())).normalized();
  pose.translation = to - pose.rotation * from;
  return pose;
}

std::vector<SeedPose> seed_poses(const KeyPoints& source, const KeyPoints& target,
                                 std::span<const Correspondence> pairs, const ConsistencyGraph& graph,
                                 const SeedOptions& options, int num_threads) {
  const Clues clues{source, target, pairs, graph, options, PairColumns(source, target, pairs)};
  return distinct(poses_of_seeds(clues, num_threads), mean_point(source), options);
}

}  // namespace augicp
