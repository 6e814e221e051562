// SPDX-License-Identifier: MIT
#include "augicp/align/covariance.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

namespace augicp {
namespace {

// Cells are told apart by a hash: two that fall together are taken as one, which adds nothing on average.
constexpr std::size_t kNumBuckets = 4096;

std::size_t bucket_of(const Vec3f& point, float cells_per_metre) {
  const auto cell = [&](int axis) { return static_cast<std::uint32_t>(static_cast<std::int32_t>(std::floor(point[axis] * cells_per_metre))); };
  std::uint32_t hash = cell(0) * 73856093u ^ cell(1) * 19349663u ^ cell(2) * 83492791u;
  hash ^= hash >> 15;
  return (hash * 2654435761u >> 16) % kNumBuckets;
}

// The pairs, those of a bucket side by side, and where each bucket begins.
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

// So many pairs tell which part of them lies beyond the kernel.
constexpr std::size_t kNumAsked = 16384;

// Those whose part of the intensity lies beyond its kernel.
std::vector<Correspondence> beyond_intensity_kernel(const Cloud& source, const Cloud& target,
                                                    const std::vector<Correspondence>& asked,
                                                    const Rigid3& target_from_source, const IntensityModel& model) {
  const std::vector<float> residuals = intensity_residuals(source, target, asked, target_from_source, 1);
  std::vector<Correspondence> beyond;
  for (std::size_t k = 0; k < asked.size(); ++k) {
    const double r = static_cast<double>(residuals[k]) - model.offset;  // NaN where they are not compared
    if (model.information * r * r > model.kernel_chi2) beyond.push_back(asked[k]);
  }
  return beyond;
}

// The loss of a pair beyond the kernel bends the other way.
Mat6d curvature(const Cloud& source, const Cloud& target, std::span<const Correspondence> pairs,
                const Rigid3& target_from_source, const Objective& objective, const Mat6d& H) {
  const std::vector<Correspondence> asked = evenly_chosen(pairs, kNumAsked);
  std::vector<Correspondence> beyond;
  const PairChi2 chi2 = chi2_of_pairs(source, target, asked, target_from_source, objective.information, 1);
  for (std::size_t k = 0; k < asked.size(); ++k) {
    const double direction = std::min(static_cast<double>(std::max(chi2.direction[k], 0.0f)), objective.kernel_direction_chi2);
    if (static_cast<double>(chi2.position[k]) + direction > objective.kernel_chi2) beyond.push_back(asked[k]);
  }
  Objective without_intensity = objective;
  without_intensity.intensity = {};
  Mat6d other_way = linearize(source, target, beyond, target_from_source, without_intensity, 1).H;
  if (const IntensityModel& model = objective.intensity; model.information > 0.0) {
    const auto shining = beyond_intensity_kernel(source, target, asked, target_from_source, model);
    other_way += linearize_intensity(source, target, shining, target_from_source, model, 1).H;
  }
  const double pairs_per_asked = static_cast<double>(pairs.size()) / static_cast<double>(asked.size());
  return H - 2.0 * pairs_per_asked * other_way;
}

}  // namespace

Mat6d covariance(const Cloud& source, const Cloud& target, std::span<const Correspondence> pairs,
                 const Rigid3& target_from_source, const Objective& objective, const NormalEquations& equations,
                 double correlation_length) {
  if (pairs.empty()) return Mat6d::Zero();
  const Buckets buckets = in_buckets(target, pairs, correlation_length);
  const std::span<const Correspondence> sorted(buckets.pairs);
  Mat6d M = Mat6d::Zero();
  int num_cells = 0;
  for (std::size_t b = 0; b < kNumBuckets; ++b) {
    const auto of_cell = sorted.subspan(buckets.begin[b], buckets.begin[b + 1] - buckets.begin[b]);
    if (of_cell.empty()) continue;
    const Vec6d g = linearize(source, target, of_cell, target_from_source, objective, 1).b;
    M += g * g.transpose();
    ++num_cells;
  }
  const Eigen::LDLT<Mat6d> solver(
      curvature(source, target, pairs, target_from_source, objective, equations.H));
  if (num_cells <= 6 || !solver.isPositive() || !(solver.vectorD().minCoeff() > 0.0)) return Mat6d::Zero();
  const Mat6d half = solver.solve(M);  // A^-1 M, whose transpose is M A^-1
  const Mat6d both = solver.solve(Mat6d(half.transpose()));
  return 0.5 * static_cast<double>(num_cells) / static_cast<double>(num_cells - 6) * (both + both.transpose());
}

}  // namespace augicp
