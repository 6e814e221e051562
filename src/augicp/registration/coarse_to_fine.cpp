// SPDX-License-Identifier: MIT
#include "augicp/registration/coarse_to_fine.h"

#include <algorithm>

#include "augicp/registration/full_resolution.h"
#include "augicp/registration/scan_match.h"
#include "augicp/registration/start/rivals.h"
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

AlignResult without_bend(const ScanPair& pair, const Start& start, const RegistrationOptions& options) {
  const Scan source = without_skew(pair.source, start.readout.source, options.num_threads),
             target = without_skew(pair.target, start.readout.target, options.num_threads);
  return FullResolution({source, target, pair.lengths}, start.guess, options).from(start.target_from_source);
}

bool is_large(const Scan& image) { return step_for(image, kCoarseColumns) > 1; }

// The first result, ambiguous if others that fit as well differ clearly from it and from each other.
AlignResult with_runners_up(std::vector<AlignResult> results, const ScanPair& pair) {
  AlignResult best = std::move(results.front());
  if (best.status != AlignStatus::Converged) return best;
  std::vector<Rigid3> known{best.target_from_source};
  std::stable_sort(results.begin() + 1, results.end(), is_better);
  for (std::size_t k = 1; k < results.size(); ++k) {
    const Rigid3& other = results[k].target_from_source;
    const bool is_new = std::all_of(known.begin(), known.end(), [&](const Rigid3& pose) {
      return differ_clearly(pair.source.cloud, other, pose, kClearlyPerRadius * pair.lengths.radius);
    });
    if (!is_new || !results[k].evidence || !fits_as_well(*results[k].evidence, *best.evidence)) continue;
    known.push_back(other);
    best.runners_up.push_back({other, *results[k].evidence});
  }
  if (!best.runners_up.empty()) best.status = AlignStatus::Ambiguous;
  return best;
}

// The guess between clouds leads to a result of its own. Only if that does not convince, other starts compete with it.
// What convinces is compared with what the scene's symmetries make of it.
AlignResult between_clouds(const ScanPair& pair, const Rigid3& guess, const RegistrationOptions& options) {
  const FullResolution full(pair, guess, options);
  std::vector<AlignResult> results{full.from(guess)};
  if (!options.search) return std::move(results.front());
  if (!is_supported(results.front()))
    for (const Rigid3& start : search_starts(pair, guess, options)) results.push_back(full.from(start));
  std::iter_swap(results.begin(), std::min_element(results.begin(), results.end(), is_better));
  // The evidence compares shapes. Rivals that brightness tells apart look alike to it.
  if (results.front().status == AlignStatus::Converged && results.front().num_intensity_pairs == 0)
    for (const Rigid3& rival : search_rivals(pair, results.front().target_from_source, options))
      if (full.is_promising(rival)) results.push_back(full.from(rival));
  return with_runners_up(std::move(results), pair);
}

// Between images the guess is led on at full resolution only if what was found on the way does not convince.
AlignResult between_images(const ScanPair& pair, const Rigid3& guess, const RegistrationOptions& options) {
  Start start{guess, guess, {}};
  if (options.search) start.target_from_source = search_starts(pair, guess, options).front();
  const bool bends = options.rolling_shutter && pair.source.view->rolling_shutter && pair.target.view->rolling_shutter;
  const bool begins_coarse = options.coarse_to_fine && (is_large(pair.source) || is_large(pair.target));
  if (bends || begins_coarse) improve(coarser(pair, kCoarseColumns, 1.0), bends, options, start);
  AlignResult found =
      bends ? without_bend(pair, start, options) : FullResolution(pair, guess, options).from(start.target_from_source);
  const bool was_the_guess = !bends && start.target_from_source.matrix() == guess.matrix();
  if (is_supported(found) || was_the_guess) return found;
  AlignResult from_guess = FullResolution(pair, guess, options).from(guess);
  return is_better(found, from_guess) ? found : from_guess;
}

}  // namespace

AlignResult coarse_to_fine(const ScanPair& pair, const Rigid3& guess_target_from_source,
                           const RegistrationOptions& options) {
  if (options.preset == Preset::Paper)
    return FullResolution(pair, guess_target_from_source, options).from(guess_target_from_source);
  const bool has_images = pair.source.view && is_projective(pair.target, options.association);
  return (has_images ? between_images : between_clouds)(pair, guess_target_from_source, options);
}

}  // namespace augicp
