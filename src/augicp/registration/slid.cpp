// SPDX-License-Identifier: MIT
#include "augicp/registration/slid.h"

#include "augicp/registration/scan_match.h"
#include "augicp/registration/scan_probe.h"
#include "augicp/trust/free_motions.h"

namespace augicp {
namespace {

// Brightness may hold what shapes do not. Images are asked by FullResolution.
bool can_be_asked(const AlignResult& result, const ScanPair& pair, const RegistrationOptions& options) {
  return options.preset != Preset::Paper && result.status == AlignStatus::Converged &&
         result.num_intensity_pairs == 0 && !pair.source.view && !pair.target.view &&
         pair.source.cloud.has_directions() && pair.target.cloud.has_directions();
}

FreeDirections not_held(const AlignResult& result, const ScanPair& pair, int num_weak) {
  std::vector<Vec6d> weak;
  weak.reserve(static_cast<std::size_t>(num_weak));
  for (int k = 0; k < num_weak; ++k) weak.push_back(result.observability.directions.col(k));
  const ScanProbe scans(pair);
  std::vector<bool> is_free(6, false);
  if (!scans.probe().can_tell()) return {result.observability, 0};
  const std::vector<bool> is_held = scans.probe().held_along(result.target_from_source, weak);
  for (std::size_t k = 0; k < weak.size(); ++k) is_free[k] = !is_held[k];
  return free_first(result.observability, is_free);
}

}  // namespace

AlignResult unless_slid(AlignResult result, const ScanPair& pair, const Guess& guess,
                        const RegistrationOptions& options) {
  if (!can_be_asked(result, pair, options)) return result;
  const double limit = align_options(pair.lengths, /*projective=*/false, options).min_observability;
  const int num_weak = result.observability.num_below(limit);
  if (num_weak == 0) return result;
  const FreeDirections free = not_held(result, pair, num_weak);
  if (free.num_free == 0) return result;
  result.observability = free.seen;
  result.free_motions = free_motions(free.seen, free.num_free);
  result.covariance.reset();
  result.status = AlignStatus::Degenerate;
  if (guess && has_left_along_free(result, *guess)) {
    result.status = AlignStatus::Doubtful;
    result.doubts.push_back(Doubt::LeftGuess);
  }
  return result;
}

}  // namespace augicp
