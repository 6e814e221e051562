// SPDX-License-Identifier: MIT
#include "augicp/registration/image_start.h"

#include "augicp/registration/scan_match.h"
#include "augicp/registration/start/start_search.h"
#include "augicp/registration/thin_scan.h"
#include "augicp/shutter/readout_motion.h"
#include "augicp/shutter/rolling_shutter.h"

namespace augicp {
namespace {

// Columns of the images that the motion during a readout is found on. Its few numbers need no more.
constexpr int kReadoutColumns = 160;

// The motion during a readout and the pose depend on each other; on fr1, a third round changes little.
constexpr int kReadoutRounds = 2;

struct Start {
  Rigid3 target_from_source;
  Guess guess;
  ReadoutMotion readout;
  Turn turn;
};

// Corridors seen by depth cameras have 0.0003 to 0.0008 along their axis, right pairs of fr1/desk 0.004 and more. With
// so little the search may take a start along the axis for a better one.
constexpr double kHardlyHeld = 1e-3;

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
  const auto index = [&] { return FullResolution(pair, start.guess, options); };
  return reported(options.on_stage, Stage::Indexing, index, start.turn).from(start.target_from_source, start.turn);
}

AlignResult without_bend(const ScanPair& pair, const Start& start, const RegistrationOptions& options) {
  const Scan source = without_skew(pair.source, start.readout.source, options.num_threads),
             target = without_skew(pair.target, start.readout.target, options.num_threads);
  return at_full_resolution({source, target, pair.lengths}, start, options);
}

bool is_large(const Scan& image) { return step_for(image, kReadoutColumns) > 1; }

bool bends(const ScanPair& pair, const RegistrationOptions& options) {
  return options.rolling_shutter && pair.source.view->rolling_shutter && pair.target.view->rolling_shutter;
}

}  // namespace

std::vector<Rigid3> searched(const ScanPair& pair, const Rigid3& guess, const RegistrationOptions& options) {
  return reported(options.on_stage, Stage::Search, [&] { return search_starts(pair, guess, options); });
}

AlignResult from_start_of_images(const ScanPair& pair, const StartInTurn& start_in_turn, const Guess& guess,
                                 const RegistrationOptions& options) {
  Start start{start_in_turn.target_from_source, guess, {}, start_in_turn.turn};
  const bool begins_coarse = options.coarse_to_fine && (is_large(pair.source) || is_large(pair.target));
  const auto improved_start = [&] {
    improve(coarser(pair, kReadoutColumns, 1.0, options.num_threads), bends(pair, options), options, start);
    return start;
  };
  if (bends(pair, options) || begins_coarse)
    start = reported(options.on_stage, Stage::Coarse, improved_start, start.turn);
  return bends(pair, options) ? without_bend(pair, start, options) : at_full_resolution(pair, start, options);
}

AlignResult from_guess_of_images(const ScanPair& pair, const Rigid3& guess, const RegistrationOptions& options) {
  const Rigid3 start = options.search ? searched(pair, guess, options).front() : guess;
  const bool begins_coarse = options.coarse_to_fine && (is_large(pair.source) || is_large(pair.target));
  AlignResult found = from_start_of_images(pair, {start}, guess, options);
  if (start.matrix() != guess.matrix() && is_supported(found) && found.observability.weakest() < kHardlyHeld) {
    AlignResult stays = from_start_of_images(pair, {guess}, guess, options);
    const bool is_free = stays.status == AlignStatus::Degenerate && is_supported(stays);
    return is_free || is_better(stays, found) ? stays : found;
  }
  const bool was_the_guess = !bends(pair, options) && !begins_coarse && start.matrix() == guess.matrix();
  if (is_supported(found) || was_the_guess) return found;
  AlignResult from_guess = at_full_resolution(pair, {guess, guess, {}, {}}, options);
  return is_better(found, from_guess) ? found : from_guess;
}

}  // namespace augicp
