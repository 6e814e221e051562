// SPDX-License-Identifier: MIT
#include "augicp/registration/coarse_to_fine.h"

#include <algorithm>
#include <iterator>

#include "augicp/registration/image_start.h"
#include "augicp/registration/scan_match.h"
#include "augicp/registration/start/global_starts.h"
#include "augicp/registration/start/rivals.h"
#include "augicp/registration/start/start_search.h"

namespace augicp {
namespace {

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

// Without a guess the most plausible start that convinces is the result. Others then compete only if they may fit too.
template <typename LeadOn>
std::vector<AlignResult> from_global_starts(const ScanPair& pair, const FullResolution& full, const LeadOn& lead_on,
                                            const RegistrationOptions& options) {
  std::vector<AlignResult> results;
  bool is_found = false;
  for (const Rigid3& start : global_starts(pair, options)) {
    if (is_found && !full.is_promising(start)) continue;
    results.push_back(lead_on(start));
    is_found = is_found || is_supported(results.back());
  }
  return results;
}

void append(std::vector<AlignResult> others, std::vector<AlignResult>& results) {
  std::move(others.begin(), others.end(), std::back_inserter(results));
}

// The result that the evidence prefers, first.
std::vector<AlignResult> best_first(std::vector<AlignResult> results) {
  std::iter_swap(results.begin(), std::min_element(results.begin(), results.end(), is_better));
  return results;
}

bool convinces(const std::vector<AlignResult>& results) {
  return std::any_of(results.begin(), results.end(), is_supported);
}

// The guess between clouds leads to a result of its own. Only if that does not convince, other starts compete with it:
// those around it and, if none convinces, those that need no guess. What convinces is compared with what the scene's
// symmetries make of it.
AlignResult between_clouds(const ScanPair& pair, const Rigid3& guess, const RegistrationOptions& options) {
  const FullResolution full(pair, options.global ? Guess{} : guess, options);
  const auto lead_on = [&](const Rigid3& start) { return full.from(start); };
  std::vector<AlignResult> results;
  if (!options.global) results.push_back(full.from(guess));
  if (!options.global && !options.search) return std::move(results.front());
  if (!options.global && !convinces(results))
    for (const Rigid3& start : search_starts(pair, guess, options)) results.push_back(full.from(start));
  if (!convinces(results)) append(from_global_starts(pair, full, lead_on, options), results);
  if (results.empty()) return full.from(guess);
  // Where nothing convinces, a pose that stays at the guess along its free motions is not left for another doubtful
  // one.
  const bool stays = !options.global && results.front().status == AlignStatus::Degenerate && !convinces(results);
  if (!stays) results = best_first(std::move(results));
  // The evidence compares shapes. Rivals that brightness tells apart look alike to it.
  if (results.front().status == AlignStatus::Converged && results.front().num_intensity_pairs == 0)
    for (const Rigid3& rival : search_rivals(pair, results.front().target_from_source, options))
      if (full.is_promising(rival)) results.push_back(full.from(rival));
  return with_runners_up(std::move(results), pair);
}

// If that does not convince either, starts that need no guess compete with it.
AlignResult between_images(const ScanPair& pair, const Rigid3& guess, const RegistrationOptions& options) {
  std::vector<AlignResult> results;
  if (!options.global) results.push_back(from_guess_of_images(pair, guess, options));
  if (!options.global && (!options.search || convinces(results))) return std::move(results.front());
  const Guess known = options.global ? Guess{} : guess;
  const auto lead_on = [&](const Rigid3& start) { return from_start_of_images(pair, start, known, options); };
  append(from_global_starts(pair, FullResolution(pair, known, options), lead_on, options), results);
  if (results.empty()) return lead_on(guess);
  return with_runners_up(best_first(std::move(results)), pair);
}

}  // namespace

AlignResult coarse_to_fine(const ScanPair& pair, const Rigid3& guess_target_from_source,
                           const RegistrationOptions& options) {
  if (options.preset == Preset::Paper)
    return FullResolution(pair, guess_target_from_source, options).from(guess_target_from_source);
  const bool has_images = pair.source.view && is_projective(pair.target, options.association);
  return (has_images ? between_images : between_clouds)(pair, guess_target_from_source, options);
}

std::vector<AlignResult> from_anywhere(const ScanPair& pair, const RegistrationOptions& options) {
  const bool has_images = pair.source.view && is_projective(pair.target, options.association);
  const FullResolution full(pair, Guess{}, options);
  std::vector<AlignResult> results;
  for (const Rigid3& start : global_starts(pair, options))
    results.push_back(has_images ? from_start_of_images(pair, start, Guess{}, options) : full.from(start));
  std::stable_sort(results.begin(), results.end(), is_better);
  if (!results.empty()) results.front() = with_runners_up(results, pair);
  return results;
}

}  // namespace augicp
