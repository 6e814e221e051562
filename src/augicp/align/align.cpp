// SPDX-License-Identifier: MIT
#include "augicp/align/align.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "augicp/align/damped_step.h"
#include "augicp/align/weighing.h"
#include "augicp/core/median.h"
#include "augicp/core/parallel.h"
#include "augicp/core/stop.h"
#include "augicp/trust/covariance.h"

namespace augicp {
namespace {

// Three points fix a motion where each gives three numbers; planes give one each, so six pairs are the least.
constexpr std::size_t kMinPairs = 6;

// With fewer source points than this share in reach of the target, what little touches says nothing.
constexpr double kMinOverlap = 0.02;

// Medians are known well enough from this many pairs, taken evenly from all.
constexpr std::size_t kTypicalPairs = 8192;

std::vector<float> squared_distances(const Cloud& source, const Cloud& target, const std::vector<Correspondence>& pairs,
                                     const Rigid3& pose, int num_threads) {
  const Eigen::Matrix3f rotation = pose.rotation.toRotationMatrix().cast<float>();
  const Vec3f translation = pose.translation.cast<float>();
  std::vector<float> distances_sq(pairs.size());
  const auto measure = [&](std::size_t begin, std::size_t end) {
    for (std::size_t k = begin; k < end; ++k) {
      const Vec3f moved = rotation * source.points[pairs[k].source] + translation;
      distances_sq[k] = (target.points[pairs[k].target] - moved).squaredNorm();
    }
  };
  for_each_block(pairs.size(), num_threads, measure, kLightBlockSize);
  return distances_sq;
}

double root_mean(const std::vector<float>& squares) {
  double sum = 0.0;
  for (float square : squares) sum += static_cast<double>(square);
  return squares.empty() ? 0.0 : std::sqrt(sum / static_cast<double>(squares.size()));
}

// The gate for the next iteration, see AlignOptions::gate_per_median.
double closed_gate(double gate, const Cloud& source, const Cloud& target, const std::vector<Correspondence>& pairs,
                   const Rigid3& pose, const AlignOptions& options) {
  if (!std::isfinite(options.gate_per_median)) return gate;
  const double typical = std::sqrt(median(squared_distances(source, target, pairs, pose, options.num_threads)));
  return std::min(gate, std::max(options.gate_per_median * typical, options.min_max_distance));
}

bool is_small(const Vec6d& step, const AlignOptions& options) {
  return step.head<3>().norm() < options.min_translation_step && step.tail<3>().norm() < options.min_rotation_step;
}

// Pairs change by leaps, so that a loop may end up going round a few poses for ever. It is where it will get to when it
// is back at one of the last ones.
bool has_returned(const Rigid3& pose, const std::vector<Rigid3>& visited, const AlignOptions& options) {
  constexpr std::size_t kLongestCycle = 8;
  const std::size_t count = std::min(kLongestCycle, visited.size());
  return std::any_of(visited.end() - static_cast<std::ptrdiff_t>(count), visited.end(),
                     [&](const Rigid3& earlier) { return is_small(increment_between(earlier, pose), options); });
}

// One pass of the loop of section 3.3, from a pose to its step; everything but the points themselves.
struct Pass {
  Gates gates;
  std::vector<Correspondence> pairs;
  std::vector<Correspondence> typical;  // some of these
  Weighing weighing;
  Objective objective;
  NormalEquations equations;
};

// Sets the status that forbids a step, if one does.
bool has_enough_pairs(const Cloud& source, const Cloud& target, AlignResult& result) {
  result.overlap = source.empty() ? 0.0 : static_cast<double>(result.num_pairs) / static_cast<double>(source.size());
  if (std::min(source.size(), target.size()) < kMinPairs) {
    result.status = AlignStatus::TooFewPairs;
  } else if (result.num_pairs < static_cast<std::int64_t>(kMinPairs) || result.overlap < kMinOverlap) {
    result.status = AlignStatus::NoOverlap;
  }
  return result.status == AlignStatus::IterationLimit;
}

void linearize_pass(const Cloud& source, const Cloud& target, const Rigid3& pose, const AlignOptions& options,
                    Pass& pass) {
  pass.typical = evenly_chosen(pass.pairs, kTypicalPairs);
  const PairChi2 chi2 = chi2_of_pairs(source, target, pass.typical, pose, options.information, options.num_threads);
  pass.weighing = weigh_pairs(chi2, options);
  pass.objective = {with_lever(options.information, pass.weighing.lever), pass.weighing.kernel_chi2,
                    pass.weighing.kernel_direction_chi2,
                    weigh_intensities(source, target, pass.typical, pose, chi2, options)};
  pass.equations = linearize(source, target, pass.pairs, pose, pass.objective, options.num_threads);
}

// A pose was reached; is every direction of it held by the pairs it came from?
void judge_observability(const Cloud& source, const Matcher& matcher, const Rigid3& pose, const Pass& pass,
                         const AlignOptions& options, AlignResult& result) {
  result.observability = observability(source, matcher.target(), pass.pairs, pose, pass.objective);
  if (result.observability.weakest() < options.min_observability)
    result.status = AlignStatus::Degenerate;
  else if (options.correlation_length > 0.0)
    result.covariance = covariance(source, matcher, {pose, pass.gates, pass.pairs, pass.objective},
                                   options.correlation_length, result.observability.directions, options.num_threads);
}

// The step that leaves the num_free weakest directions of this iteration alone.
Vec6d step_of(const Cloud& source, const Cloud& target, const Rigid3& pose, const Pass& pass,
              const AlignOptions& options, int num_free) {
  if (num_free == 0) return damped_step(pass.equations, options.damping);
  const Observability now = observability(source, target, pass.pairs, pose, pass.objective);
  return held_step(pass.equations, options.damping, now, num_free);
}

AlignResult run(const Cloud& source, const Matcher& matcher, const Rigid3& initial_target_from_source,
                const AlignOptions& options, int num_free);

// The loop, and once more without what the data leave open.
AlignResult run_held(const Cloud& source, const Matcher& matcher, const Rigid3& initial_target_from_source,
                     const AlignOptions& options) {
  AlignResult result = run(source, matcher, initial_target_from_source, options, 0);
  if (result.status != AlignStatus::Degenerate) return result;
  // What is free has wandered by then, and may have led the rest astray: once more, without it.
  const int num_free = result.observability.num_below(options.min_observability);
  AlignResult held = run(source, matcher, initial_target_from_source, options, num_free);
  if (held.observability.gyration == 0.0) return result;  // no pose was reached this way
  held.status = AlignStatus::Degenerate;
  held.free_motions = free_motions(held.observability, num_free, matcher.target().origin);
  return held;
}

}  // namespace

AlignResult align(const Cloud& source, const Matcher& matcher, const Rigid3& initial_target_from_source,
                  const AlignOptions& options) {
  options.check();
  if (!(options.intensity_weight > 0.0) || !compares_intensities(source, matcher.target()))
    return run_held(source, matcher, initial_target_from_source, options);
  // A gradient holds for as far as the points it came from, and from farther away brightness leads anywhere: shape
  // comes first.
  AlignOptions by_shape = options;
  by_shape.intensity_weight = by_shape.correlation_length = 0.0;
  AlignResult shape = run_held(source, matcher, initial_target_from_source, by_shape);
  if (!has_pose(shape.status)) return shape;
  AlignResult result = run_held(source, matcher, shape.target_from_source, options);
  result.iterations += shape.iterations;
  shape.history.insert(shape.history.end(), result.history.begin(), result.history.end());
  result.history = std::move(shape.history);
  return result;
}

namespace {

AlignResult run(const Cloud& source, const Matcher& matcher, const Rigid3& initial_target_from_source,
                const AlignOptions& options, int num_free) {
  const Cloud& target = matcher.target();
  AlignResult result;
  result.status = AlignStatus::IterationLimit;
  Rigid3 pose = without_origins(initial_target_from_source, source, target);
  Pass pass;
  pass.gates = options.gates;
  std::vector<Rigid3> visited;
  const std::unique_ptr<Matching> matching = matcher.matching(source);
  while (result.status == AlignStatus::IterationLimit && result.iterations < options.max_iterations) {
    throw_if_stopped(options.stop);
    pass.pairs = matching->match(pose, pass.gates, options.num_threads);
    result.num_pairs = static_cast<std::int64_t>(pass.pairs.size());
    if (!has_enough_pairs(source, target, result)) break;
    linearize_pass(source, target, pose, options, pass);
    const Vec6d step = step_of(source, target, pose, pass, options, num_free);
    if (!step.allFinite()) {
      result.status = AlignStatus::Diverged;
      break;
    }
    pose = retract(pose, step);
    pass.gates.max_distance = closed_gate(pass.gates.max_distance, source, target, pass.typical, pose, options);
    ++result.iterations;
    result.information = pass.equations.H;
    result.num_intensity_pairs = pass.equations.num_intensity_pairs;
    result.history.push_back({with_origins(pose, source, target), result.num_pairs, pass.equations.cost,
                              pass.weighing.kernel_chi2, pass.weighing.lever, pass.objective.intensity.information});
    if (is_small(step, options) || has_returned(pose, visited, options)) result.status = AlignStatus::Converged;
    visited.push_back(pose);
  }
  result.target_from_source = with_origins(pose, source, target);
  if (result.iterations > 0)
    result.rmse = root_mean(squared_distances(source, target, pass.pairs, pose, options.num_threads));
  if (has_pose(result.status)) judge_observability(source, matcher, pose, pass, options, result);
  return result;
}

}  // namespace
}  // namespace augicp
