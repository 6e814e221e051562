// SPDX-License-Identifier: MIT
#include "augicp/registration/coarse_to_fine.h"

#include "augicp/registration/judge.h"
#include "augicp/registration/levels.h"
#include "augicp/registration/readout_motion.h"
#include "augicp/registration/rolling_shutter.h"
#include "augicp/registration/search.h"

namespace augicp {
namespace {

// Columns of the images that the motion during a readout is found on. Its few numbers need no more.
constexpr int kThinnedColumns = 160;

// The motion during a readout and the pose depend on each other; on fr1, a third round changes little.
constexpr int kReadoutRounds = 2;

struct Start {
  Rigid3 target_from_source;
  ReadoutMotion readout;
};

SkewedPair straightened(const Scan& source, const Scan& target, const ReadoutMotion& readout, int num_threads) {
  return {source, target, without_skew(source, readout.source, num_threads),
          without_skew(target, readout.target, num_threads)};
}

// The start made better on thinned images, as long as they hold it.
Start thinned_start(const Scan& source, const Scan& target, Start start, bool bends, const Lengths& lengths,
                    const RegistrationOptions& options) {
  const Scan thin_source = coarser(source, kThinnedColumns, 1.0, lengths),
             thin_target = coarser(target, kThinnedColumns, 1.0, lengths);
  for (int round = 0; round <= (bends ? kReadoutRounds : 0); ++round) {
    const SkewedPair scans = straightened(thin_source, thin_target, start.readout, options.num_threads);
    const Level level(scans.straight_source, scans.straight_target, lengths, options);
    const AlignResult result = level.align(start.target_from_source, level.usual_options());
    // What no data hold is held at the guess, which only the last loop can do: no step before it may move it.
    if (!has_pose(result.status) || result.status == AlignStatus::Degenerate) return start;
    start.target_from_source = result.target_from_source;
    if (round < kReadoutRounds && bends)
      start.readout = improved(start.readout, scans, level.pairs(start.target_from_source), start.target_from_source);
  }
  return start;
}

AlignResult at_full_resolution(const Scan& source, const Scan& target, const Rigid3& start, const Lengths& lengths,
                               const RegistrationOptions& options) {
  const bool projective = is_projective(target, options.association);
  const std::unique_ptr<Matcher> matcher = matcher_for(target, projective);
  const AlignOptions align_by = align_options(lengths, projective, options);
  return judged(align(source.cloud, *matcher, start, align_by), source, target, *matcher, lengths, align_by);
}

}  // namespace

AlignResult coarse_to_fine(const Scan& source, const Scan& target, const Rigid3& guess_target_from_source,
                           const Lengths& lengths, const RegistrationOptions& options) {
  if (options.preset == Preset::Paper)
    return at_full_resolution(source, target, guess_target_from_source, lengths, options);
  Start start{guess_target_from_source, {}};
  if (options.search) start.target_from_source = search_start(source, target, guess_target_from_source, lengths, options);
  const bool has_images = source.view && is_projective(target, options.association);
  const bool bends = has_images && options.rolling_shutter && source.view->rolling_shutter && target.view->rolling_shutter;
  if (has_images && (options.coarse_to_fine || bends))
    start = thinned_start(source, target, start, bends, lengths, options);
  AlignResult result;
  if (bends) {
    const SkewedPair scans = straightened(source, target, start.readout, options.num_threads);
    result = at_full_resolution(scans.straight_source, scans.straight_target, start.target_from_source, lengths, options);
  } else {
    result = at_full_resolution(source, target, start.target_from_source, lengths, options);
  }
  // What the search found does not hold: say what becomes of the guess.
  if (has_pose(result.status)) return result;
  return at_full_resolution(source, target, guess_target_from_source, lengths, options);
}

}  // namespace augicp
