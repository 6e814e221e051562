// SPDX-License-Identifier: MIT
#include "augicp/trust/verdict.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "augicp/core/check.h"

namespace augicp {
namespace {

double share(std::int64_t part, std::int64_t whole) {
  return whole > 0 ? static_cast<double>(part) / static_cast<double>(whole) : 0.0;
}

// The points that should be visible.
std::int64_t visible(const Agreement& count) { return count.seen() - count.hidden; }

void require_share(const char* name, double value) {
  require(value >= 0.0 && value < 1.0, name, value, "must be from 0 to below 1");
}

// How little the guess says of the pose: 0 at the guess, 1 without any.
double distance_from_guess(const Evidence& evidence) { return std::min(evidence.moved / kMovedFromAnywhere, 1.0); }

// The ratio of what stands in free space, as the mean of both sides, to its limit without a guess.
double conflict_anywhere(const Evidence& evidence, const VerdictLimits& limits) {
  const double beyond = std::min(1.0, evidence.beyond_planes / limits.enough_beyond_planes);
  const double mean = 0.5 * (evidence.source_in_target.conflicting() + evidence.target_in_source.conflicting());
  return mean / (std::lerp(limits.conflicting_on_planes, 1.0, beyond) * limits.max_mean_conflicting);
}

// The nearer the guess, the less it counts. Each side has a limit of its own anyway.
double joint_conflict(const Evidence& evidence, const VerdictLimits& limits) {
  return distance_from_guess(evidence) * conflict_anywhere(evidence, limits);
}

// Two ratios near their limits say more against a pose than one, where both contradict it for reasons of their own.
double together(double one, double other) {
  return other > 0.0 ? std::cbrt(one * one * one + other * other * other) : one;
}

// The ratios of one cloud's values to their limits, in the order of the enumeration of doubts.
std::array<double, 5> strains(const Testimony& testimony, const VerdictLimits& limits) {
  const double min_agreeing = testimony.knows_free_space ? limits.min_agreeing : limits.min_agreeing_without_camera;
  return {(1.0 - testimony.margin()) / (1.0 - limits.min_margin), (1.0 - testimony.agreeing()) / (1.0 - min_agreeing),
          testimony.conflicting() / limits.max_conflicting, testimony.contradicting / limits.max_contradicting,
          (1.0 - testimony.off_planes) / (1.0 - limits.min_off_planes)};
}

// The ratio of what both clouds see of each other, and how well that agrees, to its limit. A mirrored room fits by
// half.
double joint_strain(const Testimony& one, const Testimony& other, const VerdictLimits& limits) {
  if (one.knows_free_space && other.knows_free_space) return 0.0;
  const double seen = 0.5 * (one.seen() + other.seen()), agreeing = 0.5 * (one.agreeing() + other.agreeing());
  const double margin = seen - limits.disagreement_weight_without_camera * (1.0 - agreeing);
  return (1.0 - margin) / (1.0 - limits.min_margin_without_camera);
}

// The ratio of the distance from the guess to what the points off the three largest planes allow.
double bare_planes(const Evidence& evidence, const VerdictLimits& limits) {
  const double beyond = std::max(1.0, evidence.beyond_planes / limits.min_beyond_planes);
  return std::min(evidence.moved, kMovedFromAnywhere) / (beyond * limits.max_moved_on_planes);
}

// The ratio of what speaks for another pose to its limit; other: the largest ratio of all other evidence. The nearer
// the guess, the less it counts.
double outvoted(const Evidence& evidence, double other, const VerdictLimits& limits) {
  return distance_from_guess(evidence) * evidence.outvoted * other / limits.max_outvoted;
}

// Whether a cloud shows all of the other.
constexpr double kAll = 0.99;
bool shows_all(const Testimony& testimony) { return testimony.seen() >= kAll && testimony.agreeing() >= kAll; }

// The larger ratios of both sides: one cloud's contradiction is not compensated by the other. But where one cloud is a
// part of the other, of which it shows all, the other has no partner for what the part lacks, and only what stands in
// the part's free space contradicts.
std::array<double, 7> strains(const Evidence& evidence, const VerdictLimits& limits) {
  auto one = strains(evidence.source_in_target, limits), other = strains(evidence.target_in_source, limits);
  const bool source_is_part = evidence.known_part == Part::Source || shows_all(evidence.source_in_target);
  const bool target_is_part = evidence.known_part == Part::Target || shows_all(evidence.target_in_source);
  if (source_is_part) other[0] = other[1] = other[3] = other[4] = 0.0;
  if (target_is_part) one[0] = one[1] = one[3] = one[4] = 0.0;
  const double joint = source_is_part || target_is_part
                           ? 0.0
                           : joint_strain(evidence.source_in_target, evidence.target_in_source, limits);
  const double bare = bare_planes(evidence, limits);
  // What one cloud has off its planes the other may not have seen, but not both. What moved between the scans stands in
  // free space, so if that is known it is asked far from the guess only.
  const bool know_free_space = evidence.source_in_target.knows_free_space && evidence.target_in_source.knows_free_space;
  const bool asks = !know_free_space || evidence.moved > limits.max_moved_near_guess;
  const double only_planes = asks ? std::min(one[4], other[4]) : 0.0;
  const double little_seen = std::max({one[0], other[0], joint}), conflict = joint_conflict(evidence, limits);
  const double both = together(little_seen, conflict);  // a doubt of the larger one
  std::array<double, 7> all{little_seen > conflict ? both : little_seen,
                            std::max(one[1], other[1]),
                            std::max({one[2], other[2], little_seen > conflict ? conflict : both}),
                            std::max(one[3], other[3]),
                            bare,
                            only_planes,
                            0.0};
  all.back() = outvoted(evidence, *std::max_element(all.begin(), all.end()), limits);
  return all;
}

// A cloud that does not know its free space calls unseen what contradicts the pose. Then a pose that leaves more unseen
// than another is the worse one. The same surface sampled twice differs by a few hundredths.
constexpr double kAlikeMargin = 0.1;
bool is_seen_as_well(const Testimony& rival, const Testimony& best) {
  return rival.knows_free_space || rival.margin() >= best.margin() - kAlikeMargin;
}

// Poses of symmetric objects differ by up to 0.05 in strain, of colonnades by up to 0.41. Poses of bare rooms,
// crossings and boxes with bosses that only some of the points fit have 0.49 to 0.9 more than the right one in most
// cases.
constexpr double kAlikeStrain = 0.4;

// Whether a rival stands in free space, clearly more than the best pose does. The rival's own distance from the guess
// counts here: near it, more is allowed.
bool is_in_free_space(const Evidence& rival, const Evidence& best, const VerdictLimits& limits) {
  const double of_rival = joint_conflict(rival, limits);
  return of_rival > 1.0 && of_rival > distance_from_guess(rival) * conflict_anywhere(best, limits) + kAlikeStrain;
}

// A limit that is missed threefold says no more against a pose than one that is missed by more: what has moved, or is
// bent, contradicts one limit of a right pose by any multiple.
constexpr double kMaxExcess = 2.0;

// Colonnades whose half-turned pose converged have up to 0.43 at the right one.
constexpr double kSmallExcess = 0.5;

}  // namespace

double Testimony::seen() const { return share(visible(count), count.total()); }
double Testimony::agreeing() const { return share(count.agree, visible(count)); }
double Testimony::margin() const { return seen() - (1.0 - agreeing()); }
double Testimony::conflicting() const { return share(count.conflict, visible(count)); }

Part part_of(const Evidence& evidence) {
  const bool source = shows_all(evidence.source_in_target), target = shows_all(evidence.target_in_source);
  return source == target ? Part::None : source ? Part::Source : Part::Target;
}

void VerdictLimits::check() const {
  require_share("min_margin", min_margin);
  require_not_negative("disagreement_weight_without_camera", disagreement_weight_without_camera);
  require_share("min_margin_without_camera", min_margin_without_camera);
  require_share("min_agreeing", min_agreeing);
  require_share("min_agreeing_without_camera", min_agreeing_without_camera);
  require_positive("max_conflicting", max_conflicting);
  require_positive("max_contradicting", max_contradicting);
  require_share("min_off_planes", min_off_planes);
  require_share("min_beyond_planes", min_beyond_planes);
  require_positive("max_moved_on_planes", max_moved_on_planes);
  require_positive("max_moved_near_guess", max_moved_near_guess);
  require_positive("max_mean_conflicting", max_mean_conflicting);
  require_positive("enough_beyond_planes", enough_beyond_planes);
  require(conflicting_on_planes > 0.0 && conflicting_on_planes <= 1.0, "conflicting_on_planes", conflicting_on_planes,
          "must be above 0 and at most 1");
  require_positive("max_outvoted", max_outvoted);
  require_not_negative("max_last_step", max_last_step);
  require_not_negative("max_last_rotation_step", max_last_rotation_step);
}

bool has_settled(const Evidence& evidence, const VerdictLimits& limits) {
  return evidence.last_step < limits.max_last_step && evidence.last_rotation_step < limits.max_last_rotation_step;
}

double strain(const Evidence& evidence, const VerdictLimits& limits) {
  const auto all = strains(evidence, limits);
  return *std::max_element(all.begin(), all.end());
}

double excess(const Evidence& evidence, const VerdictLimits& limits) {
  double sum = 0.0;
  for (const double ratio : strains(evidence, limits)) sum += std::clamp(ratio - 1.0, 0.0, kMaxExcess);
  return sum;
}

Verdict decide(AlignStatus reached, const Evidence& evidence, const VerdictLimits& limits) {
  Verdict verdict{reached, {}};
  const auto all = strains(evidence, limits);
  for (std::size_t k = 0; k < all.size(); ++k)
    if (!(all[k] <= 1.0)) verdict.doubts.push_back(static_cast<Doubt>(k));
  if (reached != AlignStatus::Converged && reached != AlignStatus::IterationLimit) return verdict;
  if (!verdict.doubts.empty())
    verdict.status = AlignStatus::Doubtful;
  else if (has_settled(evidence, limits))
    verdict.status = AlignStatus::Converged;
  return verdict;
}

bool fits_as_well(Evidence rival, const Evidence& best, const VerdictLimits& limits) {
  if (!has_settled(rival, limits) || is_in_free_space(rival, best, limits)) return false;
  rival.moved = std::min(rival.moved, best.moved);
  if (!(strain(rival, limits) <= strain(best, limits) + kAlikeStrain)) return false;
  // What a part lacks says nothing of the best pose, and nothing of the rival.
  return (best.known_part == Part::Target || is_seen_as_well(rival.source_in_target, best.source_in_target)) &&
         (best.known_part == Part::Source || is_seen_as_well(rival.target_in_source, best.target_in_source));
}

bool may_fit(Evidence of_guess, const Evidence& best, const VerdictLimits& limits) {
  of_guess.moved = std::min(of_guess.moved, best.moved);
  return excess(of_guess, limits) <= kSmallExcess;
}

}  // namespace augicp
