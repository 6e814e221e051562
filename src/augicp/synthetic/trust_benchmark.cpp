// SPDX-License-Identifier: MIT
#include "augicp/synthetic/trust_benchmark.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <mutex>

#include "augicp/core/angles.h"
#include "augicp/core/parallel.h"
#include "augicp/registration/registration.h"
#include "augicp/testing/degenerate_families.h"
#include "augicp/trust/free_motions.h"
#include "augicp/trust/verdict.h"

namespace augicp::synthetic {
namespace {

constexpr double kMaxAxisError = 5.0 * kRadPerDeg;

bool is_named(const TrustPair& pair, const AlignResult& result) {
  if (result.free_motions.size() != pair.free_motions.size()) return false;
  const testing::DegenerateFamily truth{"", {}, pair.free_motions, 0.0};
  const Observability& seen = result.observability;
  std::vector<Vec6d> found;
  for (std::size_t k = 0; k < pair.free_motions.size(); ++k)
    found.push_back(seen.directions.col(static_cast<Eigen::Index>(k)));
  return testing::angle_to_free(truth, found, seen.gyration, seen.centroid) < kMaxAxisError;
}

double share_up_to(const std::vector<double>& strains, double limit) {
  if (strains.empty()) return 0.0;
  const auto count = std::count_if(strains.begin(), strains.end(), [&](double strain) { return strain <= limit; });
  return static_cast<double>(count) / static_cast<double>(strains.size());
}

}  // namespace

double move_along_free(const AlignResult& result, const Rigid3& guess, const Cloud& source, const Cloud& target) {
  return moved_along(result.observability, static_cast<int>(result.free_motions.size()),
                     increment_between(without_origins(guess, source, target),
                                       without_origins(result.target_from_source, source, target)));
}

TrustOutcome outcome_of(unsigned seed, const TrustPair& pair, const PoseError& right, const AlignResult& result) {
  TrustOutcome outcome;
  outcome.seed = seed;
  outcome.status = result.status;
  if (pair.target_from_source) outcome.error = pose_error(result.target_from_source, *pair.target_from_source);
  outcome.is_right = outcome.error && is_within(*outcome.error, right);
  outcome.evidence = result.evidence;
  outcome.strain = result.evidence ? strain(*result.evidence) : std::numeric_limits<double>::infinity();
  if (result.status != AlignStatus::Degenerate) return outcome;
  outcome.is_named = is_named(pair, result);
  outcome.moved_along_free = move_along_free(result, pair.guess, pair.source.cloud, pair.target.cloud);
  return outcome;
}

std::vector<TrustOutcome> run_trust(const TrustFamily& family, std::span<const unsigned> seeds,
                                    const RegistrationOptions& options, const std::function<void()>& on_pair) {
  RegistrationOptions of_pair = options;
  of_pair.num_threads = 1;
  std::vector<TrustOutcome> outcomes(seeds.size());
  std::mutex one_at_a_time;
  const auto register_pair = [&](std::size_t k) {
    const TrustPair pair = family.draw(seeds[k]);
    const AlignResult result = register_scans(pair.source, pair.target, pair.guess, of_pair).result;
    outcomes[k] = outcome_of(seeds[k], pair, family.right, result);
    const std::lock_guard lock(one_at_a_time);
    if (on_pair) on_pair();
  };
  for_each_block(
      seeds.size(), options.num_threads, [&](std::size_t begin, std::size_t) { register_pair(begin); }, 1);
  return outcomes;
}

std::vector<unsigned> trust_seeds(TrustHalf half, unsigned first, std::size_t count) {
  const unsigned remainder = half == TrustHalf::Choose ? 1 : 0;
  std::vector<unsigned> seeds;
  for (unsigned seed = first + (first % 2 != remainder); seeds.size() < count; seed += 2) seeds.push_back(seed);
  return seeds;
}

TrustRow row_of(std::span<const TrustOutcome> outcomes) {
  TrustRow row;
  row.num_pairs = outcomes.size();
  for (const TrustOutcome& outcome : outcomes) {
    const bool is_right = outcome.is_right;
    if (outcome.status == AlignStatus::Degenerate) {
      ++row.degenerate;
      row.named += outcome.is_named;
      row.largest_move = std::max(row.largest_move, outcome.moved_along_free);
    } else if (outcome.status == AlignStatus::Ambiguous) {
      ++row.ambiguous;
    } else if (outcome.status == AlignStatus::Converged) {
      ++(is_right ? row.right_converged : row.wrong_converged);
    } else {
      ++(is_right ? row.right_refused : row.wrong_refused);
    }
  }
  return row;
}

std::vector<TrustRocPoint> trust_roc(std::span<const TrustOutcome> outcomes) {
  std::vector<double> right, wrong;
  for (const TrustOutcome& outcome : outcomes)
    if (outcome.status == AlignStatus::Converged || outcome.status == AlignStatus::Doubtful)
      (outcome.is_right ? right : wrong).push_back(outcome.strain);
  std::vector<TrustRocPoint> points;
  for (const double max_strain : {0.5, 0.6, 0.7, 0.8, 0.9, 1.0, 1.1, 1.25, 1.5, 2.0, 3.0, 5.0})
    points.push_back({max_strain, share_up_to(wrong, max_strain), 1.0 - share_up_to(right, max_strain)});
  return points;
}

}  // namespace augicp::synthetic
