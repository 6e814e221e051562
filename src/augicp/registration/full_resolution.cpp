// SPDX-License-Identifier: MIT
#include "augicp/registration/full_resolution.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "augicp/cloud/voxel_grid.h"
#include "augicp/core/parallel.h"
#include "augicp/registration/scan_match.h"
#include "augicp/registration/scan_probe.h"
#include "augicp/registration/start/rivals.h"
#include "augicp/trust/motion_probe.h"

namespace augicp {
namespace {

// Rivals that end as ambiguities begin with a strain of 0.8 to 1.2 on few points; those that lead back to the pose
// found begin above 6, and cost as much as the registration.
constexpr double kMaxStrainOfRival = 2.0;

// Enough for a pose that is off by a voxel of the search.
constexpr std::size_t kNumRefining = 1000;
constexpr int kRefiningIterations = 10;

// Directions with more information than this are not asked about: in bare corridors noise and rings give less to the
// free one (0.0058 in the worst of a hundred generated ones).
constexpr double kMaxDoubtfulInformation = 0.01;

// The normals of images are even: they cannot feign more information than this many times the square of the angle by
// which paired ones differ (0.3 to 1.6 in corridors with one to three times a Kinect's noise).
constexpr double kFeignedPerNoise = 3.0;

// Newton steps back to the guess along the free motions. Beside a rotation of nearly half a turn there may be no way
// back.
constexpr int kMaxStepsBack = 20;
constexpr double kNoStepBack = 1e-9;  // metres and radians

// What is free at one pose may not be at another, but rarely changes twice.
constexpr int kMaxRounds = 2;

// A motion below this many radii is within the tolerance.
constexpr double kMaxIdleMove = 0.5;

FreeDirections free_of(const AlignResult& result) {
  return {result.observability, static_cast<int>(result.free_motions.size())};
}

using Matchers = std::pair<std::unique_ptr<ScanMatcher>, std::unique_ptr<ScanMatcher>>;

Matchers matchers_of(const ScanPair& pair, const RegistrationOptions& options) {
  const bool projective = is_projective(pair.target, options.association);
  return both(
      options.num_threads, [&] { return matcher_for(pair.target, projective, pair.lengths); },
      [&] { return matcher_of_source(pair); });
}

}  // namespace

FullResolution::FullResolution(const ScanPair& pair, const Guess& guess_target_from_source,
                               const RegistrationOptions& options)
    : FullResolution(pair, guess_target_from_source, options, matchers_of(pair, options)) {}

FullResolution::FullResolution(const ScanPair& pair, const Guess& guess_target_from_source,
                               const RegistrationOptions& options, Matchers matchers)
    : pair_(pair),
      guess_target_from_source_(guess_target_from_source),
      is_paper_(options.preset == Preset::Paper),
      align_by_(align_options(pair.lengths, is_projective(pair.target, options.association), options)),
      on_stage_(options.on_stage),
      matcher_(std::move(matchers.first)),
      judge_(pair, *matcher_, guess_target_from_source, align_by_, std::move(matchers.second)) {}

AlignResult FullResolution::aligned(const Rigid3& start, const std::optional<FreeDirections>& free) const {
  AlignOptions options = align_by_;
  options.free_directions = free;
  const auto from = [&](const Rigid3& pose) { return align(pair_.source.cloud, *matcher_, pose, options); };
  if (!free) return from(start);
  AlignResult result = from(at_guess_along(*free, start));
  // Steps beside the free directions add up to a little motion along them, in large rotations.
  for (int k = 0; k < kMaxRounds && free->num_free > 0 && has_pose(result.status); ++k) {
    const Rigid3 back = at_guess_along(*free, result.target_from_source);
    if (increment_between(result.target_from_source, back).norm() < align_by_.min_translation_step) break;
    result = from(back);
  }
  return result;
}

// Directions with less information than this are doubtful.
double FullResolution::doubtful_information(const AlignResult& result) const {
  if (!pair_.target.view) return kMaxDoubtfulInformation;
  const PosedPairs posed{pair_.source.cloud, pair_.target.cloud, result.pairs, result.target_from_source};
  const double noise = residuals(posed).normal.median;
  return std::clamp(kFeignedPerNoise * noise * noise, align_by_.min_observability, kMaxDoubtfulInformation);
}

// Of the directions with little information, those that the scans say nothing of; where they are too sparse to tell,
// those that the loop found free.
FreeDirections FullResolution::free_directions(const AlignResult& result, const MotionProbe& probe) const {
  const Observability& seen = result.observability;
  const int num_doubtful = seen.num_below(doubtful_information(result));
  std::vector<bool> is_free(6, false);
  if (!probe.can_tell()) return free_of(result);
  std::vector<Vec6d> doubtful;
  doubtful.reserve(static_cast<std::size_t>(num_doubtful));
  for (int k = 0; k < num_doubtful; ++k) doubtful.push_back(seen.directions.col(k));
  const std::vector<bool> is_spoken_of = probe.spoken_of(result.target_from_source, doubtful);
  for (std::size_t k = 0; k < doubtful.size(); ++k)
    is_free[k] = !is_spoken_of[k] || (pair_.target.view && k < result.free_motions.size());
  return free_first(seen, is_free);
}

// The motions that no data constrain leave the target as it is, so they are undone in its frame, whatever rotation lies
// between the guess and the pose. For a small one the first step is exact.
Rigid3 FullResolution::at_guess_along(const FreeDirections& free, const Rigid3& target_from_source) const {
  if (free.num_free == 0 || !guess_target_from_source_) return target_from_source;
  const auto along_all = free.seen.directions.fullPivLu();
  Rigid3 pose = target_from_source;
  for (int step = 0; step < kMaxStepsBack; ++step) {
    Vec6d along = along_all.solve(increment_between(*guess_target_from_source_, pose));
    along.tail(6 - free.num_free).setZero();
    pose = retract(pose, -free.seen.directions * along);
    if (along.norm() < kNoStepBack) return pose;
  }
  return target_from_source;
}

// Whether the scans can be asked: brightness may constrain what shapes do not.
bool FullResolution::can_be_asked(const AlignResult& result) const {
  return !is_paper_ && has_pose(result.status) && result.num_intensity_pairs == 0 &&
         pair_.source.cloud.has_directions() && pair_.target.cloud.has_directions();
}

// Whether a result that has moved along a direction with little information is worth it: the scans agree on clearly
// more, or no less and it is where it was. Without this, what little constrains a bare wall would pull the pose along
// it.
bool FullResolution::is_gain(const AlignResult& again, const AlignResult& result, const MotionProbe& probe) const {
  const Rigid3 &to = again.target_from_source, &from = result.target_from_source;
  const int change = probe.compared(to, from);
  return change > 0 ||
         (change == 0 && !differ_clearly(pair_.source.cloud, to, from, kMaxIdleMove * pair_.lengths.radius));
}

// The result from a start, once the scans have said which of its doubtful directions are free.
AlignResult FullResolution::asked(AlignResult first, const Rigid3& start) const {
  const ScanProbe scans(pair_);
  const MotionProbe& probe = scans.probe();
  const bool was_at_guess =
      first.free_motions.empty() || !guess_target_from_source_ || start.matrix() == guess_target_from_source_->matrix();
  // The way back to the guess may be long: a motion that is free nearby is not for ever.
  if (!was_at_guess)
    if (AlignResult at_guess = aligned(start, free_of(first));
        has_pose(at_guess.status) && probe.compared(at_guess.target_from_source, first.target_from_source) >= 0)
      first = std::move(at_guess);
  AlignResult result = first;
  for (int round = 0; round < kMaxRounds && has_pose(result.status); ++round) {
    const FreeDirections known = free_of(result), free = free_directions(result, probe);
    if (free.num_free == known.num_free && free.seen.directions == known.seen.directions) break;
    result = aligned(start, free);
  }
  const bool is_bolder = result.free_motions.size() < first.free_motions.size();
  const bool is_kept = has_pose(result.status) && (!is_bolder || is_gain(result, first, probe));
  return held_where_idle(is_kept ? result : first, start);
}

// What noise gives to a free motion makes a little more of the scans agree where the loop has taken it. So an image
// pair moves along a doubtful direction only where the scans agree on clearly more than with that one at the guess.
AlignResult FullResolution::held_where_idle(AlignResult result, const Rigid3& start) const {
  if (!pair_.target.view || !has_pose(result.status)) return result;
  const Observability seen = result.observability;
  const auto num_free = result.free_motions.size();
  const auto num_doubtful = static_cast<std::size_t>(seen.num_below(doubtful_information(result)));
  std::vector<bool> is_free(6, false);
  std::fill_n(is_free.begin(), num_free, true);
  for (std::size_t k = num_free; k < num_doubtful; ++k) {
    is_free[k] = true;
    AlignResult held = aligned(start, free_first(seen, is_free));
    const Rigid3 &at_guess = held.target_from_source, &moved = result.target_from_source;
    is_free[k] = has_pose(held.status) &&
                 differ_clearly(pair_.source.cloud, at_guess, moved, kMaxIdleMove * pair_.lengths.radius) &&
                 !agree_on_more(judge_.agreements(moved), judge_.agreements(at_guess));
    if (is_free[k]) result = std::move(held);
  }
  return result;
}

bool FullResolution::is_doubtful(const AlignResult& result) const {
  return !result.free_motions.empty() || result.observability.num_below(doubtful_information(result)) > 0;
}

AlignResult FullResolution::found_from(const Rigid3& start) const {
  AlignResult result = aligned(start, std::nullopt);
  if (can_be_asked(result) && is_doubtful(result)) result = asked(std::move(result), start);
  return result;
}

AlignResult FullResolution::from(const Rigid3& start, Turn turn) const {
  AlignResult result = reported(
      on_stage_, Stage::Aligning, [&] { return found_from(start); }, turn);
  return reported(
      on_stage_, Stage::Verdict, [&] { return judge_.judged(std::move(result)); }, turn);
}

Rigid3 FullResolution::refined(const Rigid3& target_from_source) const {
  AlignOptions options = align_by_;
  options.max_iterations = kRefiningIterations;
  options.correlation_length = 0.0;  // nobody asks how sure it is
  const Cloud few = evenly_chosen(pair_.source.cloud, kNumRefining);
  const AlignResult result = align(few, *matcher_, target_from_source, options);
  return has_pose(result.status) ? result.target_from_source : target_from_source;
}

bool FullResolution::is_promising(const Rigid3& target_from_source, double max_moved) const {
  Evidence evidence = judge_.evidence(target_from_source);
  evidence.moved = std::min(evidence.moved, max_moved);
  return strain(evidence) < kMaxStrainOfRival;
}

}  // namespace augicp
