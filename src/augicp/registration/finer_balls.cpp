// SPDX-License-Identifier: MIT
#include "augicp/registration/finer_balls.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "augicp/registration/coarse_to_fine.h"
#include "augicp/registration/judge.h"
#include "augicp/registration/memory.h"
#include "augicp/registration/scan_match.h"
#include "augicp/registration/start/rivals.h"

namespace augicp {
namespace {

// A ball of half the radius still has as many voxels as the first one.
constexpr double kFinerShare = 0.5;

// Supported by the evidence, alone or beside others.
bool is_found(const AlignResult& result) {
  return result.status == AlignStatus::Converged || result.status == AlignStatus::Ambiguous;
}

std::vector<Rigid3> poses_of(const AlignResult& result) {
  std::vector<Rigid3> poses{result.target_from_source};
  for (const RunnerUp& other : result.runners_up) poses.push_back(other.target_from_source);
  return poses;
}

// What the judge of the first balls knows of a pose to which the loop in finer ones led.
Evidence evidence_of(const Judge& judge_of_first, const Rigid3& target_from_source, const Evidence& in_finer) {
  Evidence evidence = judge_of_first.evidence(target_from_source);
  evidence.last_step = in_finer.last_step;
  evidence.last_rotation_step = in_finer.last_rotation_step;
  evidence.moved = in_finer.moved;
  evidence.outvoted = in_finer.outvoted;
  return evidence;
}

// Drops the runners-up that the judge of the first balls does not support. Whether it supports the best pose.
bool is_supported_by(const Judge& judge_of_first, AlignResult& finer) {
  const Evidence best = evidence_of(judge_of_first, finer.target_from_source, *finer.evidence);
  std::erase_if(finer.runners_up, [&](const RunnerUp& other) {
    return !fits_as_well(evidence_of(judge_of_first, other.target_from_source, other.evidence), best);
  });
  if (finer.runners_up.empty()) finer.status = AlignStatus::Converged;
  return strain(best) <= 1.0;
}

bool replaces(Registration& finer, const Registration& first, const AlignOptions& align_by, const Guess& guess) {
  const ScanPair pair = first.prepared;
  if (is_found(finer.result)) {
    const auto matcher = matcher_for(pair.target, /*projective=*/false, pair.lengths);
    return is_supported_by(Judge(pair, *matcher, guess, align_by), finer.result);
  }
  return finer.result.status == AlignStatus::Degenerate &&
         !differ_clearly(pair.source.cloud, finer.result.target_from_source, first.result.target_from_source,
                         finer.prepared.lengths.radius);
}

Registration registered_finer(const Registration& first, const RawPair& raw, const Guess& guess,
                              const RegistrationOptions& options) {
  const auto prepare_finer = [&] {
    return prepare_both(raw, finer_lengths(first.prepared.lengths, kFinerShare), options);
  };
  PreparedPair finer = reported(options.on_stage, Stage::FinerBalls, prepare_finer);
  // Smaller balls allow less: some of a part then disagrees, and no longer shows by itself that it is one.
  ScanPair pair = finer;
  pair.known_part = part_of(*first.result.evidence);
  AlignResult result = from_known(pair, poses_of(first.result), guess, options);
  if (result.evidence) result.evidence->outvoted = first.result.evidence->outvoted;
  return {std::move(result), std::move(finer)};
}

}  // namespace

bool may_have_finer_balls(const Scan& source, const Scan& target, const RegistrationOptions& options) {
  return options.preset == Preset::Default && !options.radius && !options.voxel_size && !source.view && !target.view;
}

Registration in_finer_balls(Registration first, const RawPair& raw, const Guess& guess,
                            const RegistrationOptions& options) {
  const AlignOptions align_by = align_options(first.prepared.lengths, /*projective=*/false, options);
  if (!is_found(first.result) || first.result.observability.weakest() >= align_by.min_observability) return first;
  try {
    Registration finer = registered_finer(first, raw, guess, options);
    return replaces(finer, first, align_by, guess) ? std::move(finer) : std::move(first);
  } catch (const TooMuchMemory&) {  // the first result needed less
    return first;
  }
}

}  // namespace augicp
