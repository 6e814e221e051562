// SPDX-License-Identifier: MIT
#include "augicp/align/align.h"

#include <stdexcept>
#include <utility>

#include "augicp/align/iteration.h"
#include "augicp/align/scout.h"
#include "augicp/align/stretch.h"
#include "augicp/core/stop.h"
#include "augicp/trust/covariance.h"

namespace augicp {
namespace {

AlignIteration record_of(const Rigid3& pose, const Iteration& iteration) {
  return {pose,
          static_cast<std::int64_t>(iteration.pairs.size()),
          iteration.equations.cost,
          iteration.weighing.kernel_chi2,
          iteration.weighing.lever,
          iteration.objective.intensity.information};
}

// What a loop is given, beside its start.
struct Task {
  const KnownClouds& clouds;
  const AlignOptions& options;
  int num_free;
};

// Computes, for the final pose and the last pairs, whether every direction is constrained, and the covariance.
void judge_certainty(const Matcher& matcher, const PosedPairs& posed, const Iteration& last,
                     const AlignOptions& options, AlignResult& result) {
  result.rmse = rms_distance(posed, options.num_threads);
  if (!has_pose(result.status)) return;
  result.observability = observability(posed, last.objective);
  if (!options.free_directions && result.observability.weakest() < options.min_observability)
    result.status = AlignStatus::Degenerate;
  else if (options.correlation_length > 0.0)
    result.covariance = covariance(matcher, {posed, last.gates, last.objective}, options.correlation_length,
                                   result.observability.directions, options.num_threads);
}

// The loop of section 3.3. The increments do not move in the num_free weakest directions. Returns what follows from its
// steps; the last iteration goes to `now`. Ends at a known pose.
AlignResult stepped(const Task& task, const Rigid3& initial_target_from_source, const KnowsPose& is_known,
                    Iteration& now) {
  const auto& [clouds, options, num_free] = task;
  const Cloud &source = clouds.source, &target = clouds.matcher.target();
  AlignResult result;
  result.status = AlignStatus::IterationLimit;
  Rigid3 pose = initial_target_from_source;  // T
  std::vector<Rigid3> visited;
  Stretch stretch(options);
  now.gates = options.gates;
  while (result.status == AlignStatus::IterationLimit && result.iterations < options.max_iterations) {
    throw_if_stopped(options.stop);
    now.pairs = clouds.session.match(pose, now.gates, options.num_threads);  // (j, i): section 4.1
    if (!has_enough_pairs(source, target, now, result)) break;
    const PosedPairs posed{source, target, now.pairs, pose};
    weigh(posed, options, now);                                            // Omega: Table 2; K of Eq. (13)
    now.equations = linearize(posed, now.objective, options.num_threads);  // e, J, gamma, H, b: Eq. (8) to (14)
    const Vec6d increment = increment_of(posed, now, options, num_free);   // (H + lambda I) dT = -b: Eq. (10)
    if (!increment.allFinite()) {
      result.status = AlignStatus::Diverged;
      break;
    }
    pose = retract(pose, stretch.of(increment));  // T <- dT (+) T
    now.gates.max_distance = closed_gate({source, target, now.typical, pose}, now.gates.max_distance, options);
    ++result.iterations;
    result.information = now.equations.H;
    result.num_intensity_pairs = now.equations.num_intensity_pairs;
    result.history.push_back(record_of(pose, now));
    if (is_small(increment, options) || has_returned(pose, visited, options)) result.status = AlignStatus::Converged;
    visited.push_back(pose);
    if (is_known && is_known(pose)) break;
  }
  result.target_from_source = pose;
  return result;
}

// The loop, and what its last pairs say of its pose.
AlignResult iterate(const KnownClouds& clouds, const Rigid3& initial_target_from_source, const AlignOptions& options,
                    int num_free) {
  Iteration now;
  AlignResult result = stepped({clouds, options, num_free}, initial_target_from_source, {}, now);
  if (result.iterations == 0) return result;
  const PosedPairs posed{clouds.source, clouds.matcher.target(), now.pairs, result.target_from_source};
  judge_certainty(clouds.matcher, posed, now, options, result);
  result.pairs = std::move(now.pairs);
  result.objective = now.objective;
  return result;
}

// The loop where the free directions are known.
AlignResult align_beside(const FreeDirections& free, const KnownClouds& clouds,
                         const Rigid3& initial_target_from_source, AlignOptions options) {
  if (free.num_free > 0) options.correlation_length = 0.0;
  AlignResult result = iterate(clouds, initial_target_from_source, options, free.num_free);
  if (free.num_free == 0 || result.observability.gyration == 0.0) return result;
  result.status = AlignStatus::Degenerate;
  result.observability = free.seen;
  result.free_motions = free_motions(free.seen, free.num_free);
  return result;
}

void require_gaussians(const Cloud& target, const InformationModel& information) {
  if (information.position_sides == Sides::TargetGaussian && !target.empty() && !target.has_gaussians())
    throw std::invalid_argument("the target has no Gaussians; see estimate_gaussians(), or prepare() with Method::Ndt");
}

// The loop and, if the data leave directions free, the loop again without these.
AlignResult align_by(const KnownClouds& clouds, const Rigid3& initial_target_from_source, const AlignOptions& options) {
  if (options.free_directions)
    return align_beside(*options.free_directions, clouds, initial_target_from_source, options);
  AlignResult result = iterate(clouds, initial_target_from_source, options, 0);
  if (result.status != AlignStatus::Degenerate) return result;
  // The free directions have drifted, and may have pulled the others along. So start again, without them.
  const int num_free = result.observability.num_below(options.min_observability);
  AlignResult held = iterate(clouds, initial_target_from_source, options, num_free);
  if (held.observability.gyration == 0.0) return result;  // this loop found no pose
  held.status = AlignStatus::Degenerate;
  held.free_motions = free_motions(held.observability, num_free);
  return held;
}

}  // namespace

std::optional<Rigid3> scouted(const KnownClouds& clouds, const Rigid3& initial_target_from_source,
                              const AlignOptions& options, const KnowsPose& is_known) {
  options.check();
  require_gaussians(clouds.matcher.target(), options.information);
  AlignOptions by_shape = options;
  by_shape.intensity_weight = 0.0;
  Iteration last;
  const AlignResult found = stepped({clouds, by_shape, 0}, initial_target_from_source, is_known, last);
  if (!has_pose(found.status) || is_known(found.target_from_source)) return std::nullopt;
  return found.target_from_source;
}

AlignResult align(const Cloud& source, const Matcher& matcher, const Rigid3& initial_target_from_source,
                  const AlignOptions& options) {
  return align({source, matcher, *matcher.session(source)}, initial_target_from_source, options);
}

AlignResult align(const KnownClouds& clouds, const Rigid3& initial_target_from_source, const AlignOptions& options) {
  options.check();
  const Cloud& target = clouds.matcher.target();
  require_gaussians(target, options.information);
  if (!(options.intensity_weight > 0.0) || !compares_intensities(clouds.source, target))
    return align_by(clouds, initial_target_from_source, options);
  // A gradient of the intensity is valid only near its points; from farther away brightness leads anywhere. So shape
  // comes first.
  AlignOptions by_shape = options;
  by_shape.intensity_weight = by_shape.correlation_length = 0.0;
  AlignResult shape = align_by(clouds, initial_target_from_source, by_shape);
  if (!has_pose(shape.status)) return shape;
  AlignResult result = align_by(clouds, shape.target_from_source, options);
  result.iterations += shape.iterations;
  shape.history.insert(shape.history.end(), result.history.begin(), result.history.end());
  result.history = std::move(shape.history);
  return result;
}

}  // namespace augicp
