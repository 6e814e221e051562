// SPDX-License-Identifier: MIT
#include "augicp/registration/coarse_to_fine.h"

#include <algorithm>

#include "augicp/registration/judge.h"
#include "augicp/registration/start/start_search.h"
#include "augicp/registration/thin_scan.h"
#include "augicp/shutter/readout_motion.h"
#include "augicp/shutter/rolling_shutter.h"

namespace augicp {
namespace {

// Columns of the images that the motion during a readout is found on. Its few numbers need no more.
constexpr int kThinnedColumns = 160;

// The motion during a readout and the pose depend on each other; on fr1, a third round changes little.
constexpr int kReadoutRounds = 2;

struct Start {
  Rigid3 target_from_source, guess;
  ReadoutMotion readout;
};

// What the loop at full resolution would do, on thinned scans. False where they hold no pose, or leave a part of it
// open: what no data hold is held at the guess, which only the last loop can do, so that no step before it may move it.
bool align_thinned(const Scan& source, const Scan& target, const Lengths& lengths, const RegistrationOptions& options,
                   Rigid3& target_from_source, std::vector<Correspondence>& pairs) {
  const ScanMatch level(source, target, lengths, options);
  const AlignResult result = level.align(target_from_source, level.usual_options());
  if (!has_pose(result.status) || result.status == AlignStatus::Degenerate) return false;
  target_from_source = result.target_from_source;
  pairs = level.pairs(target_from_source);
  return true;
}

// The start made better on thinned images, as long as they hold it.
void improve_thinned(const Scan& source, const Scan& target, bool bends, const Lengths& lengths,
                     const RegistrationOptions& options, Start& start) {
  std::vector<Correspondence> pairs;
  if (!align_thinned(source, target, lengths, options, start.target_from_source, pairs) || !bends) return;
  SkewedPair scans{source, target, source, target};
  for (int round = 0; round < kReadoutRounds; ++round) {
    start.readout = improved(start.readout, scans, pairs, start.target_from_source);
    scans.straight_source = without_skew(source, start.readout.source, options.num_threads);
    scans.straight_target = without_skew(target, start.readout.target, options.num_threads);
    if (!align_thinned(scans.straight_source, scans.straight_target, lengths, options, start.target_from_source, pairs))
      return;
  }
}

AlignResult at_full_resolution(const Scan& source, const Scan& target, const Start& start, const Lengths& lengths,
                               const RegistrationOptions& options) {
  const bool projective = is_projective(target, options.association);
  const std::unique_ptr<Matcher> matcher = matcher_for(target, projective);
  const AlignOptions align_by = align_options(lengths, projective, options);
  return judged(align(source.cloud, *matcher, start.target_from_source, align_by), source, target, *matcher,
                start.guess, lengths, align_by);
}

}  // namespace

AlignResult coarse_to_fine(const Scan& source, const Scan& target, const Rigid3& guess_target_from_source,
                           const Lengths& lengths, const RegistrationOptions& options) {
  const Start guess{guess_target_from_source, guess_target_from_source, {}};
  if (options.preset == Preset::Paper) return at_full_resolution(source, target, guess, lengths, options);
  Start start = guess;
  if (options.search)
    start.target_from_source = search_start(source, target, guess_target_from_source, lengths, options);
  const bool has_images = source.view && is_projective(target, options.association);
  const bool bends =
      has_images && options.rolling_shutter && source.view->rolling_shutter && target.view->rolling_shutter;
  const bool is_large =
      has_images && std::max(step_for(source, kThinnedColumns), step_for(target, kThinnedColumns)) > 1;
  if (bends || (options.coarse_to_fine && is_large))
    improve_thinned(coarser(source, kThinnedColumns, 1.0, lengths), coarser(target, kThinnedColumns, 1.0, lengths),
                    bends, lengths, options, start);
  const int num_threads = options.num_threads;
  const AlignResult result =
      bends ? at_full_resolution(without_skew(source, start.readout.source, num_threads),
                                 without_skew(target, start.readout.target, num_threads), start, lengths, options)
            : at_full_resolution(source, target, start, lengths, options);
  // What was found on the way does not hold: say what becomes of the guess.
  const bool was_the_guess = !bends && start.target_from_source.matrix() == guess_target_from_source.matrix();
  if (has_pose(result.status) || was_the_guess) return result;
  return at_full_resolution(source, target, guess, lengths, options);
}

}  // namespace augicp
