// SPDX-License-Identifier: MIT
#include "augicp/align/iteration.h"

#include <algorithm>
#include <cmath>

#include "augicp/align/damped_step.h"
#include "augicp/core/median.h"
#include "augicp/core/parallel.h"

namespace augicp {
namespace {

// Three points determine a motion if each gives three numbers. A plane gives one, so six pairs are the least.
constexpr std::size_t kMinPairs = 6;

// If a smaller share of the source points is in reach of the target, the few correspondences mean nothing.
constexpr double kMinOverlap = 0.02;

// This many pairs, evenly selected, suffice for medians.
constexpr std::size_t kTypicalPairs = 8192;

std::vector<float> squared_distances(const PosedPairs& posed, int num_threads) {
  const Rigid3f pose(posed.target_from_source);
  std::vector<float> distances_sq(posed.size());
  const auto measure = [&](std::size_t begin, std::size_t end) {
    for (std::size_t k = begin; k < end; ++k) {
      const Vec3f moved = pose * posed.source.points[posed.pairs[k].source];
      distances_sq[k] = (posed.target.points[posed.pairs[k].target] - moved).squaredNorm();
    }
  };
  for_each_block(posed.size(), num_threads, measure, kLightBlockSize);
  return distances_sq;
}

}  // namespace

bool has_enough_pairs(const Cloud& source, const Cloud& target, const Iteration& iteration, AlignResult& result) {
  result.num_pairs = static_cast<std::int64_t>(iteration.pairs.size());
  result.overlap = source.empty() ? 0.0 : static_cast<double>(result.num_pairs) / static_cast<double>(source.size());
  if (std::min(source.size(), target.size()) < kMinPairs) {
    result.status = AlignStatus::TooFewPairs;
  } else if (result.num_pairs < static_cast<std::int64_t>(kMinPairs) || result.overlap < kMinOverlap) {
    result.status = AlignStatus::NoOverlap;
  }
  return result.status == AlignStatus::IterationLimit;
}

void weigh(const PosedPairs& posed, const AlignOptions& options, Iteration& iteration) {
  iteration.typical = evenly_chosen(posed.pairs, kTypicalPairs);
  const PosedPairs typical = posed.with(iteration.typical);
  const PairChi2 chi2 = chi2_of_pairs(typical, options.information, options.num_threads);
  iteration.weighing = weigh_pairs(chi2, options);
  iteration.objective = {with_lever(options.information, iteration.weighing.lever), iteration.weighing.kernel_chi2,
                         iteration.weighing.kernel_direction_chi2, weigh_intensities(typical, chi2, options)};
}

Vec6d increment_of(const PosedPairs& posed, const Iteration& iteration, const AlignOptions& options, int num_free) {
  if (num_free == 0) return damped_step(iteration.equations, options.damping);
  if (options.free_directions)
    return held_step(iteration.equations, options.damping, options.free_directions->seen, num_free);
  return held_step(iteration.equations, options.damping, observability(posed, iteration.objective), num_free);
}

double closed_gate(const PosedPairs& posed, double gate, const AlignOptions& options) {
  if (!std::isfinite(options.gate_per_median)) return gate;
  const double typical = std::sqrt(median(squared_distances(posed, options.num_threads)));
  return std::min(gate, std::max(options.gate_per_median * typical, options.min_max_distance));
}

bool is_small(const Vec6d& increment, const AlignOptions& options) {
  return increment.head<3>().norm() < options.min_translation_step &&
         increment.tail<3>().norm() < options.min_rotation_step;
}

bool has_returned(const Rigid3& pose, const std::vector<Rigid3>& visited, const AlignOptions& options) {
  constexpr std::size_t kLongestCycle = 8;
  const std::size_t count = std::min(kLongestCycle, visited.size());
  return std::any_of(visited.end() - static_cast<std::ptrdiff_t>(count), visited.end(),
                     [&](const Rigid3& earlier) { return is_small(increment_between(earlier, pose), options); });
}

double rms_distance(const PosedPairs& posed, int num_threads) {
  double sum = 0.0;
  for (const float square : squared_distances(posed, num_threads)) sum += static_cast<double>(square);
  return posed.pairs.empty() ? 0.0 : std::sqrt(sum / static_cast<double>(posed.size()));
}

}  // namespace augicp
