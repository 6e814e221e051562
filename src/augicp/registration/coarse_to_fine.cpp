// SPDX-License-Identifier: MIT
#include "augicp/registration/coarse_to_fine.h"

#include <algorithm>
#include <iterator>

#include "augicp/registration/image_start.h"
#include "augicp/registration/scan_match.h"
#include "augicp/registration/start/global_starts.h"
#include "augicp/registration/start/rivals.h"
#include "augicp/registration/start/start_search.h"
#include "augicp/registration/start/votes.h"

namespace augicp {
namespace {

bool fits(const AlignResult& result, const AlignResult& best, const std::optional<Rigid3>& led_to_by_guess) {
  if (!result.evidence) return false;
  const bool is_of_guess = led_to_by_guess && led_to_by_guess->matrix() == result.target_from_source.matrix();
  return fits_as_well(*result.evidence, *best.evidence) || (is_of_guess && may_fit(*result.evidence, *best.evidence));
}

// The first result, ambiguous if others that fit as well differ clearly from it and from each other.
AlignResult with_runners_up(std::vector<AlignResult> results, const ScanPair& pair,
                            const std::optional<Rigid3>& led_to_by_guess = {}) {
  AlignResult best = std::move(results.front());
  if (best.status != AlignStatus::Converged) return best;
  std::vector<Rigid3> known{best.target_from_source};
  std::stable_sort(results.begin() + 1, results.end(), is_better);
  for (std::size_t k = 1; k < results.size(); ++k) {
    const Rigid3& other = results[k].target_from_source;
    const bool is_new = std::all_of(known.begin(), known.end(), [&](const Rigid3& pose) {
      return differ_clearly(pair.source.cloud, other, pose, kClearlyPerRadius * pair.lengths.radius);
    });
    if (!is_new || !fits(results[k], best, led_to_by_guess)) continue;
    known.push_back(other);
    best.runners_up.push_back({other, *results[k].evidence});
  }
  if (!best.runners_up.empty()) best.status = AlignStatus::Ambiguous;
  return best;
}

GlobalStarts proposed(const ScanPair& pair, const RegistrationOptions& options) {
  return reported(options.on_stage, Stage::Descriptors, [&] { return global_starts(pair, options); });
}

FullResolution indexed(const ScanPair& pair, const Guess& guess, const RegistrationOptions& options) {
  return reported(options.on_stage, Stage::Indexing, [&] { return FullResolution(pair, guess, options); });
}

bool convinces(const std::vector<AlignResult>& results) {
  return std::any_of(results.begin(), results.end(), is_supported);
}

// Appends the results of starts that need no guess: all until one convinces, then only those that may fit too.
template <typename LeadOn>
void lead_on_promising(const std::vector<Rigid3>& starts, const FullResolution& full, const LeadOn& lead_on,
                       std::vector<AlignResult>& results) {
  bool is_found = convinces(results);
  for (std::size_t k = 0; k < starts.size(); ++k) {
    if (is_found && !full.is_promising(starts[k])) continue;
    results.push_back(lead_on(starts[k], Turn{k, starts.size()}));
    is_found = is_found || is_supported(results.back());
  }
}

// Whether it converged where the guess says little.
bool has_converged_far_off(const AlignResult& result) {
  return result.status == AlignStatus::Converged && result.evidence->moved > VerdictLimits{}.max_moved_near_guess;
}

// Far from the guess, a pose that converged is doubtful if many more points look alike under another one.
AlignResult with_votes(AlignResult result, const ScanPair& pair, std::span<const SeedPose> seeds) {
  if (!has_converged_far_off(result)) return result;
  result.evidence->outvoted = outvoted(pair.source.cloud, result.target_from_source, seeds, pair.lengths.radius);
  const Verdict verdict = decide(result.status, *result.evidence);
  result.status = verdict.status;
  result.doubts = verdict.doubts;
  return result;
}

bool is_elsewhere(const Rigid3& target_from_source, const AlignResult& found, const ScanPair& pair) {
  return differ_clearly(pair.source.cloud, target_from_source, found.target_from_source,
                        kClearlyPerRadius * pair.lengths.radius);
}

void append(std::vector<AlignResult> others, std::vector<AlignResult>& results) {
  std::move(others.begin(), others.end(), std::back_inserter(results));
}

// The result that the evidence prefers, first.
std::vector<AlignResult> best_first(std::vector<AlignResult> results) {
  std::iter_swap(results.begin(), std::min_element(results.begin(), results.end(), is_better));
  return results;
}

// The results from all starts.
std::vector<AlignResult> from_each(const FullResolution& full, const std::vector<Rigid3>& starts) {
  std::vector<AlignResult> results;
  for (std::size_t k = 0; k < starts.size(); ++k) results.push_back(full.from(starts[k], {k, starts.size()}));
  return results;
}

// A pose that was found on few points and may fit: itself, or where it leads to. It is off by up to the spacing of the
// points, more than thin walls allow.
std::optional<Rigid3> promising(const Rigid3& found_on_few, const AlignResult& best, const FullResolution& full) {
  const double moved = best.evidence->moved;
  if (full.is_promising(found_on_few, moved)) return found_on_few;
  const Rigid3 refined = full.refined(found_on_few);
  return full.is_promising(refined, moved) ? std::optional(refined) : std::nullopt;
}

std::vector<Rigid3> rivals_of(const AlignResult& found, const ScanPair& pair, const FullResolution& full,
                              const RegistrationOptions& options) {
  const std::vector<Rigid3> rivals =
      reported(options.on_stage, Stage::Rivals, [&] { return search_rivals(pair, found.target_from_source, options); });
  std::vector<Rigid3> chosen;
  for (const Rigid3& rival : rivals) {
    const std::optional<Rigid3> start = promising(rival, found, full);
    if (start && is_elsewhere(*start, found, pair)) chosen.push_back(*start);
  }
  return chosen;
}

// The result that the evidence prefers, first, unless it has left the guess along what is free: elsewhere on a flat
// field, or upside down. Then that of the guess stays first.
std::vector<AlignResult> best_at_guess_first(std::vector<AlignResult> results, const Guess& guess) {
  const auto best = std::min_element(results.begin(), results.end(), is_better);
  if (!guess || best->doubts != std::vector<Doubt>{Doubt::LeftGuess}) std::iter_swap(results.begin(), best);
  return results;
}

// Results of which the first converged, and those from its rivals. The evidence compares shapes: rivals that brightness
// tells apart look alike to it.
std::vector<AlignResult> with_rivals(std::vector<AlignResult> results, const ScanPair& pair, const FullResolution& full,
                                     const RegistrationOptions& options) {
  if (results.front().status == AlignStatus::Converged && results.front().num_intensity_pairs == 0)
    append(from_each(full, rivals_of(results.front(), pair, full, options)), results);
  return results;
}

// Whether starts that need no guess are to compete: where nothing convinces, or only what is far from the guess.
bool needs_global_starts(const std::vector<AlignResult>& results) {
  return std::none_of(results.begin(), results.end(),
                      [](const AlignResult& result) { return is_supported(result) && !has_converged_far_off(result); });
}

// The guess between clouds leads to a result of its own. Only if that does not convince, other starts compete with it:
// those around it and, if none near it convinces, those that need no guess. What convinces is compared with what the
// scene's symmetries make of it.
AlignResult between_clouds(const ScanPair& pair, const Rigid3& guess, const RegistrationOptions& options) {
  const Guess known = options.global ? Guess{} : guess;
  const FullResolution full = indexed(pair, known, options);
  const auto lead_on = [&](const Rigid3& start, Turn turn) { return full.from(start, turn); };
  std::vector<AlignResult> results;
  if (!options.global) results.push_back(full.from(guess));
  if (!options.global && !options.search) return std::move(results.front());
  if (!options.global && !convinces(results)) append(from_each(full, searched(pair, guess, options)), results);
  GlobalStarts global;
  if (needs_global_starts(results)) global = proposed(pair, options);
  lead_on_promising(global.starts_target_from_source, full, lead_on, results);
  if (results.empty()) return full.from(guess);
  // Where nothing convinces, a pose that stays at the guess along its free motions is not left for another doubtful
  // one.
  const bool stays = !options.global && results.front().status == AlignStatus::Degenerate && !convinces(results);
  std::optional<Rigid3> led_to_by_guess;
  if (!options.global) led_to_by_guess = results.front().target_from_source;
  if (!stays) results = best_at_guess_first(std::move(results), known);
  results = with_rivals(std::move(results), pair, full, options);
  return with_votes(with_runners_up(std::move(results), pair, led_to_by_guess), pair, global.seeds);
}

// If that does not convince either, starts that need no guess compete with it.
AlignResult between_images(const ScanPair& pair, const Rigid3& guess, const RegistrationOptions& options) {
  std::vector<AlignResult> results;
  if (!options.global) results.push_back(from_guess_of_images(pair, guess, options));
  if (!options.global && (!options.search || convinces(results))) return std::move(results.front());
  const Guess known = options.global ? Guess{} : guess;
  const auto lead_on = [&](const Rigid3& start, Turn turn) {
    return from_start_of_images(pair, {start, turn}, known, options);
  };
  const GlobalStarts global = proposed(pair, options);
  lead_on_promising(global.starts_target_from_source, indexed(pair, known, options), lead_on, results);
  if (results.empty()) return lead_on(guess, {});
  return with_votes(with_runners_up(best_first(std::move(results)), pair), pair, global.seeds);
}

// At most one of two clearly different poses is right, even if both have converged.
void disown(AlignResult& other, const AlignResult& best, const ScanPair& pair) {
  if (other.status == AlignStatus::Converged && has_pose(best.status) &&
      is_elsewhere(other.target_from_source, best, pair))
    other.status = AlignStatus::Ambiguous;
}

}  // namespace

AlignResult coarse_to_fine(const ScanPair& pair, const Rigid3& guess_target_from_source,
                           const RegistrationOptions& options) {
  if (options.preset == Preset::Paper)
    return indexed(pair, guess_target_from_source, options).from(guess_target_from_source);
  const bool has_images = pair.source.view && is_projective(pair.target, options.association);
  return (has_images ? between_images : between_clouds)(pair, guess_target_from_source, options);
}

AlignResult from_known(const ScanPair& pair, const std::vector<Rigid3>& starts, const Guess& guess,
                       const RegistrationOptions& options) {
  const FullResolution full = indexed(pair, guess, options);
  std::vector<AlignResult> results = from_each(full, starts);
  if (!is_supported(results.front())) results = best_at_guess_first(std::move(results), guess);
  if (options.search) results = with_rivals(std::move(results), pair, full, options);
  return with_runners_up(std::move(results), pair);
}

std::vector<AlignResult> from_anywhere(const ScanPair& pair, const RegistrationOptions& options) {
  const bool has_images = pair.source.view && is_projective(pair.target, options.association);
  const FullResolution full = indexed(pair, Guess{}, options);
  const GlobalStarts global = proposed(pair, options);
  const std::vector<Rigid3>& starts = global.starts_target_from_source;
  std::vector<AlignResult> results;
  for (std::size_t k = 0; k < starts.size(); ++k) {
    const Turn turn{k, starts.size()};
    results.push_back(has_images ? from_start_of_images(pair, {starts[k], turn}, Guess{}, options)
                                 : full.from(starts[k], turn));
  }
  if (results.empty()) return results;
  results = best_first(std::move(results));
  if (!has_images) results = with_rivals(std::move(results), pair, full, options);
  std::stable_sort(results.begin() + 1, results.end(), is_better);
  results.front() = with_votes(with_runners_up(results, pair), pair, global.seeds);
  std::for_each(results.begin() + 1, results.end(), [&](AlignResult& other) { disown(other, results.front(), pair); });
  return results;
}

}  // namespace augicp
