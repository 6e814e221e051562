// SPDX-License-Identifier: MIT
#include "augicp/registration/coarse_to_fine.h"

#include <algorithm>

#include "augicp/registration/judge.h"
#include "augicp/registration/scan_match.h"
#include "augicp/registration/start/start_search.h"
#include "augicp/registration/thin_scan.h"
#include "augicp/shutter/readout_motion.h"
#include "augicp/shutter/rolling_shutter.h"

namespace augicp {
namespace {

// Columns of the images that the motion during a readout is found on. Its few numbers need no more.
constexpr int kCoarseColumns = 160;

// The motion during a readout and the pose depend on each other; on fr1, a third round changes little.
constexpr int kReadoutRounds = 2;

struct Start {
  Rigid3 target_from_source, guess;
  ReadoutMotion readout;
};

// What the loop at full resolution would do, on coarse scans. Absent where they leave a part of the pose free: what no
// data constrain stays at the guess, which only the last loop can do, so that no step before it may move it.
std::optional<AlignResult> align_coarse(const ScanPair& coarse, const Rigid3& start,
                                        const RegistrationOptions& options) {
  const ScanMatch match(coarse, options);
  AlignResult result = match.align(start, match.usual_options());
  if (!has_pose(result.status) || result.status == AlignStatus::Degenerate) return std::nullopt;
  result.pairs = match.pairs(result.target_from_source);
  return result;
}

// The start improved on coarse images, as long as they constrain it.
void improve(const PreparedPair& coarse, bool bends, const RegistrationOptions& options, Start& start) {
  std::optional<AlignResult> found = align_coarse(coarse, start.target_from_source, options);
  if (!found) return;
  start.target_from_source = found->target_from_source;
  if (!bends) return;
  SkewedPair scans{coarse.source, coarse.target, coarse.source, coarse.target};
  for (int round = 0; round < kReadoutRounds; ++round) {
    start.readout = improved(start.readout, scans, found->pairs, start.target_from_source);
    scans.straight_source = without_skew(coarse.source, start.readout.source, options.num_threads);
    scans.straight_target = without_skew(coarse.target, start.readout.target, options.num_threads);
    found =
        align_coarse({scans.straight_source, scans.straight_target, coarse.lengths}, start.target_from_source, options);
    if (!found) return;
    start.target_from_source = found->target_from_source;
  }
}

AlignResult at_full_resolution(const ScanPair& pair, const Start& start, const RegistrationOptions& options) {
  const bool projective = is_projective(pair.target, options.association);
  const std::unique_ptr<ScanMatcher> matcher = matcher_for(pair.target, projective);
  const AlignOptions align_by = align_options(pair.lengths, projective, options);
  return judged(align(pair.source.cloud, *matcher, start.target_from_source, align_by), pair, *matcher, start.guess,
                align_by);
}

AlignResult without_bend(const ScanPair& pair, const Start& start, const RegistrationOptions& options) {
  const Scan source = without_skew(pair.source, start.readout.source, options.num_threads),
             target = without_skew(pair.target, start.readout.target, options.num_threads);
  return at_full_resolution({source, target, pair.lengths}, start, options);
}

bool is_large(const Scan& image) { return step_for(image, kCoarseColumns) > 1; }

}  // namespace

AlignResult coarse_to_fine(const ScanPair& pair, const Rigid3& guess_target_from_source,
                           const RegistrationOptions& options) {
  const Start guess{guess_target_from_source, guess_target_from_source, {}};
  if (options.preset == Preset::Paper) return at_full_resolution(pair, guess, options);
  Start start = guess;
  if (options.search) start.target_from_source = search_start(pair, guess_target_from_source, options);
  const bool has_images = pair.source.view && is_projective(pair.target, options.association);
  const bool bends =
      has_images && options.rolling_shutter && pair.source.view->rolling_shutter && pair.target.view->rolling_shutter;
  const bool begins_coarse = has_images && options.coarse_to_fine && (is_large(pair.source) || is_large(pair.target));
  if (bends || begins_coarse) improve(coarser(pair, kCoarseColumns, 1.0), bends, options, start);
  const AlignResult result = bends ? without_bend(pair, start, options) : at_full_resolution(pair, start, options);
  // What was found on the way may fail at full resolution: then the result is what becomes of the guess.
  const bool was_the_guess = !bends && start.target_from_source.matrix() == guess_target_from_source.matrix();
  if (has_pose(result.status) || was_the_guess) return result;
  return at_full_resolution(pair, guess, options);
}

}  // namespace augicp
