// SPDX-License-Identifier: MIT
#include "augicp/trust/covariance.h"

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include "augicp/cloud/voxel_grid.h"
#include "augicp/core/parallel.h"
#include "augicp/geometry/rigid3.h"
#include "augicp/geometry/rotation.h"

namespace augicp {
namespace {

// Cells are identified by a hash. Two cells with the same hash count as one, which adds nothing on average.
constexpr std::size_t kNumBuckets = 4096;

std::size_t bucket_of(const Vec3f& point, float cells_per_metre) {
  constexpr float kFarthest = 2e9f;  // fits into an integer
  const auto cell = [&](int axis) {
    const float place = std::floor(point[axis] * cells_per_metre);
    return static_cast<std::uint32_t>(static_cast<std::int32_t>(std::clamp(place, -kFarthest, kFarthest)));
  };
  std::uint32_t hash = cell(0) * 73856093u ^ cell(1) * 19349663u ^ cell(2) * 83492791u;
  hash ^= hash >> 15;
  return (hash * 2654435761u >> 16) % kNumBuckets;
}

// The pairs ordered by bucket, and the begin of each bucket.
struct Buckets {
  std::vector<Correspondence> pairs;
  std::array<std::size_t, kNumBuckets + 1> begin{};
};

Buckets in_buckets(const Cloud& target, std::span<const Correspondence> pairs, double cell_size) {
  const auto cells_per_metre = static_cast<float>(1.0 / cell_size);
  std::vector<std::uint16_t> bucket(pairs.size());
  Buckets sorted{std::vector<Correspondence>(pairs.size()), {}};
  for (std::size_t k = 0; k < pairs.size(); ++k) {
    bucket[k] = static_cast<std::uint16_t>(bucket_of(target.points[pairs[k].target], cells_per_metre));
    ++sorted.begin[bucket[k] + 1u];
  }
  for (std::size_t b = 0; b < kNumBuckets; ++b) sorted.begin[b + 1] += sorted.begin[b];
  auto next = sorted.begin;
  for (std::size_t k = 0; k < pairs.size(); ++k) sorted.pairs[next[bucket[k]]++] = pairs[k];
  return sorted;
}

// This many source points give the curvature to a few hundredths.
constexpr std::size_t kNumPointsAsked = 4096;

// Small against the ball of a point's direction, large against the jumps of single pairs.
constexpr double kStepPerLength = 0.05;

// The change of the gradient with the pose, by central differences along each direction, with the pairs of each pose.
// Rotations are about the centroid of the pairs: about a distant zero they would move all points far.
Mat6d curvature(const Matcher& matcher, const Solution& solution, const Mat6d& directions, double step,
                int num_threads) {
  const Cloud& source = solution.posed.source;
  const Rigid3& minimum = solution.posed.target_from_source;
  const Cloud asked = evenly_chosen(source, kNumPointsAsked);
  std::vector<Rigid3> poses;  // ahead and back along each direction
  for (Eigen::Index k = 0; k < 6; ++k)
    for (const double sign : {1.0, -1.0}) poses.push_back(retract(minimum, sign * step * directions.col(k)));
  const auto pairs = matcher.match_each(asked, poses, solution.gates, num_threads);
  const auto gradient = [&](std::size_t k) -> Vec6d {
    return linearize({asked, matcher.target(), pairs[k], poses[k]}, solution.objective, 1).b;
  };
  Mat6d changes;
  const auto change_along = [&](std::size_t k, std::size_t) {
    changes.col(static_cast<Eigen::Index>(k)) = (gradient(2 * k) - gradient(2 * k + 1)) / (2.0 * step);
  };
  for_each_block(6, num_threads, change_along, 1);
  const double points_per_asked = static_cast<double>(source.size()) / static_cast<double>(asked.size());
  const Mat6d along = 0.5 * points_per_asked * (directions.transpose() * changes + changes.transpose() * directions);
  const Mat6d back = directions.inverse();
  return back.transpose() * along * back;
}

// The sum over cells of g g^T, before the correction for the six fitted numbers. Empty if there are too few cells.
std::optional<Mat6d> spread_of_gradients(const Solution& solution, double cell_size, int num_threads) {
  const PosedPairs& posed = solution.posed;
  const Buckets buckets = in_buckets(posed.target, posed.pairs, cell_size);
  const std::vector<Vec6d> gradients =
      gradients_of_groups(posed.with(buckets.pairs), buckets.begin, solution.objective, num_threads);
  Mat6d products = Mat6d::Zero();
  int num_cells = 0;
  for (std::size_t b = 0; b < kNumBuckets; ++b) {
    if (buckets.begin[b] == buckets.begin[b + 1]) continue;
    products += gradients[b] * gradients[b].transpose();
    ++num_cells;
  }
  if (num_cells <= 6) return std::nullopt;
  return static_cast<double>(num_cells) / static_cast<double>(num_cells - 6) * products;
}

}  // namespace

std::optional<Mat6d> covariance(const Matcher& matcher, const Solution& solution, double correlation_length,
                                const Mat6d& directions, int num_threads) {
  const auto M = spread_of_gradients(solution, correlation_length, num_threads);
  if (!M) return std::nullopt;
  const Eigen::LDLT<Mat6d> A(
      curvature(matcher, solution, directions, kStepPerLength * correlation_length, num_threads));
  if (A.info() != Eigen::Success || !(A.vectorD().minCoeff() > 0.0)) return std::nullopt;
  const Mat6d half = A.solve(*M);  // A^-1 M, whose transpose is M A^-1
  const Mat6d both = A.solve(Mat6d(half.transpose()));
  return 0.5 * (both + both.transpose());
}

Mat6d covariance_about(const Mat6d& covariance, const Vec3d& offset) {
  Mat6d moved_from_increment = Mat6d::Identity();
  moved_from_increment.topRightCorner<3, 3>() = -cross_matrix(offset);  // r x offset = -offset x r
  return moved_from_increment * covariance * moved_from_increment.transpose();
}

double rms_motion(const Mat6d& covariance, const Cloud& cloud) {
  if (cloud.empty()) return 0.0;
  Vec3d mean = Vec3d::Zero();
  Mat3d second = Mat3d::Zero();
  for (const Vec3f& point : cloud.points) {
    const Vec3d p = point.cast<double>();
    mean += p;
    second += p * p.transpose();
  }
  const auto count = static_cast<double>(cloud.size());
  mean /= count;
  const Mat3d spread = second / count - mean * mean.transpose();
  const Mat6d about_mean = covariance_about(covariance, mean);
  // E |r x p|^2 = trace(C (trace(S) I - S)) for rotations r of covariance C and points p of covariance S about zero.
  const Mat3d arm = spread.trace() * Mat3d::Identity() - spread;
  return std::sqrt(about_mean.topLeftCorner<3, 3>().trace() + (about_mean.bottomRightCorner<3, 3>() * arm).trace());
}

}  // namespace augicp
