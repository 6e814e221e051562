// SPDX-License-Identifier: MIT
#include "augicp/align/align.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "augicp/align/damped_step.h"
#include "augicp/align/weighing.h"
#include "augicp/core/check.h"

namespace augicp {
namespace {

// Three points fix a motion where each gives three numbers; planes give one each, so six pairs are the least.
constexpr std::int64_t kMinPairs = 6;

// With fewer source points than this share in reach of the target, what little touches says nothing.
constexpr double kMinOverlap = 0.02;

double rmse_of(const Cloud& source, const Cloud& target, const std::vector<Correspondence>& pairs, const Rigid3& pose) {
  double sum_sq = 0.0;
  for (const Correspondence& pair : pairs)
    sum_sq += (target.points[pair.target].cast<double>() - pose * source.points[pair.source].cast<double>()).squaredNorm();
  return pairs.empty() ? 0.0 : std::sqrt(sum_sq / static_cast<double>(pairs.size()));
}

// What keeps these pairs from giving a pose, if anything does. Many pairs may still be with a few target points only.
std::optional<AlignStatus> lack_of(const Cloud& source, const Cloud& target, std::int64_t num_pairs, double overlap) {
  if (std::min(source.size(), target.size()) < kMinPairs) return AlignStatus::TooFewPairs;
  if (overlap < kMinOverlap) return AlignStatus::NoOverlap;
  if (num_pairs < kMinPairs) return AlignStatus::TooFewPairs;
  return std::nullopt;
}

bool is_small(const Vec6d& step, const AlignOptions& options) {
  return step.head<3>().norm() < options.min_translation_step && step.tail<3>().norm() < options.min_rotation_step;
}

}  // namespace

void AlignOptions::check() const {
  information.check();
  gates.check();
  if (lever) require_not_negative("lever", *lever);
  require(max_lever >= 0.0, "max_lever", max_lever, "must be at least 0");
  if (kernel_chi2) require(*kernel_chi2 > 0.0, "kernel_chi2", *kernel_chi2, "must be above 0");
  require_positive("kernel_per_median", kernel_per_median);
  require_not_negative("damping", damping);
  require(max_iterations > 0, "max_iterations", max_iterations, "must be at least 1");
  require_not_negative("min_translation_step", min_translation_step);
  require_not_negative("min_rotation_step", min_rotation_step);
  require(num_threads >= 0, "num_threads", num_threads, "must be at least 0 (0: all)");
}

std::string_view name_of(AlignStatus status) {
  constexpr std::array<std::string_view, 6> kNames{"converged",     "iteration_limit", "degenerate",
                                                   "too_few_pairs", "no_overlap",      "diverged"};
  return kNames[static_cast<std::size_t>(status)];
}

AlignResult align(const Cloud& source, const Matcher& matcher, const Rigid3& initial_target_from_source,
                  const AlignOptions& options) {
  options.check();
  const Cloud& target = matcher.target();
  AlignResult result;
  result.target_from_source = initial_target_from_source;
  result.status = AlignStatus::IterationLimit;
  Rigid3 pose = without_origins(initial_target_from_source, source, target);
  std::vector<Correspondence> pairs;
  while (result.status == AlignStatus::IterationLimit && result.iterations < options.max_iterations) {
    pairs = matcher.match(source, pose, options.gates, options.num_threads);
    result.num_pairs = static_cast<std::int64_t>(pairs.size());
    result.overlap = source.empty() ? 0.0 : static_cast<double>(pairs.size()) / static_cast<double>(source.size());
    if (const auto lack = lack_of(source, target, result.num_pairs, result.overlap)) {
      result.status = *lack;
      break;
    }
    const PairChi2 chi2 = chi2_of_pairs(source, target, pairs, pose, options.information, options.num_threads);
    const Weighing weighing = weigh_pairs(chi2, options);
    const Objective objective{with_lever(options.information, weighing.lever), weighing.kernel_chi2};
    const NormalEquations equations = linearize(source, target, pairs, pose, objective, options.num_threads);
    const Vec6d step = damped_step(equations, options.damping);
    if (!step.allFinite()) {
      result.status = AlignStatus::Diverged;
      break;
    }
    pose = retract(pose, step);
    ++result.iterations;
    result.information = equations.H;
    result.history.push_back(
        {with_origins(pose, source, target), result.num_pairs, equations.cost, weighing.kernel_chi2, weighing.lever});
    if (is_small(step, options)) result.status = AlignStatus::Converged;
  }
  result.target_from_source = with_origins(pose, source, target);
  result.rmse = rmse_of(source, target, pairs, pose);
  return result;
}

}  // namespace augicp
