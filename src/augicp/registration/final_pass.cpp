// SPDX-License-Identifier: MIT
#include "augicp/registration/final_pass.h"

#include <optional>
#include <utility>

#include "augicp/core/stop.h"
#include "augicp/registration/judge.h"
#include "augicp/registration/memory.h"
#include "augicp/registration/scan_match.h"
#include "augicp/trust/covariance.h"

namespace augicp {
namespace {

// Chosen on odd seeds of generated rooms and LiDAR scans (docs/lab/first_hour.md): a half leaves too few points in a
// ball, and 0.85 gains half as much.
constexpr double kFinalShare = 0.7;

// Smaller gains of the expected error are chance: of odd seeds with less, half ended farther from the truth.
constexpr double kMaxRatioOfErrors = 0.85;

// The loop from the first pose, with the iterations that are left.
AlignResult aligned_again(const ScanPair& finer, const AlignResult& first, const ScanMatcher& matcher,
                          const RegistrationOptions& options) {
  AlignOptions align_by = align_options(finer.lengths, /*projective=*/false, options);
  align_by.max_iterations -= first.iterations;
  if (align_by.max_iterations < 1) return {};
  AlignResult again = align(finer.source.cloud, matcher, first.target_from_source, align_by);
  again.iterations += first.iterations;
  again.history.insert(again.history.begin(), first.history.begin(), first.history.end());
  return again;
}

bool is_more_certain(const AlignResult& again, const AlignResult& first, const Cloud& target) {
  return again.status == AlignStatus::Converged && again.covariance &&
         rms_motion(*again.covariance, target) < kMaxRatioOfErrors * rms_motion(*first.covariance, target);
}

AlignResult judged_like_first(AlignResult again, const ScanPair& first, const Guess& guess,
                              const RegistrationOptions& options) {
  const auto matcher = matcher_for(first.target, /*projective=*/false, first.lengths);
  return Judge(first, *matcher, guess, align_options(first.lengths, /*projective=*/false, options))
      .judged(std::move(again));
}

// Nothing if the first result is to be kept.
std::optional<Registration> aligned_finer(const Registration& first, RawPair raw, const Guess& guess,
                                          const RegistrationOptions& options) {
  PreparedPair finer = prepare_both(std::move(raw), finer_lengths(first.prepared.lengths, kFinalShare), options);
  throw_if_stopped(options.stop);
  const auto matcher = matcher_for(finer.target, /*projective=*/false, finer.lengths);
  AlignResult again = aligned_again(finer, first.result, *matcher, options);
  if (!is_more_certain(again, first.result, first.prepared.target.cloud)) return std::nullopt;
  again = judged_like_first(std::move(again), first.prepared, guess, options);
  if (again.status != AlignStatus::Converged) return std::nullopt;
  again.evidence->outvoted = first.result.evidence->outvoted;
  if (strain(*again.evidence) > 1.0) return std::nullopt;
  return Registration{std::move(again), std::move(finer)};
}

}  // namespace

Registration with_final_pass(Registration first, RawPair raw, const Guess& guess, const RegistrationOptions& options) {
  if (first.result.status != AlignStatus::Converged || !first.result.covariance) return first;
  const auto again = [&]() -> std::optional<Registration> {
    try {
      return aligned_finer(first, std::move(raw), guess, options);
    } catch (const TooMuchMemory&) {  // the first result needed less
      return std::nullopt;
    }
  };
  std::optional<Registration> finer = reported(options.on_stage, Stage::FinalPass, again);
  return finer ? *std::move(finer) : std::move(first);
}

}  // namespace augicp
