// SPDX-License-Identifier: MIT
#include "augicp/registration/start/global_starts.h"

#include <algorithm>

#include "augicp/core/angles.h"
#include "augicp/core/stop.h"
#include "augicp/global/candidate_poses.h"
#include "augicp/registration/start/lead_on.h"
#include "augicp/registration/thin_scan.h"

namespace augicp {
namespace {

// Part of the ball in which surfaces are estimated: descriptors of five and ten voxels are of two and a half and five
// balls, a twelfth and a sixth of the extent.
constexpr double kSeedVoxelPerRadius = 0.5;

constexpr std::size_t kMaxGlobalCandidates = 4;

// The best supported candidates are led on with more points whatever few points say of them: at little overlap these
// take the right one for less plausible than others.
constexpr std::size_t kKeptBySupport = 2;

// Poses that are led on, of those proposed: leading one on costs as much as comparing the clouds seven times.
constexpr std::size_t kMaxSeedsLedOn = 24;

// How finely the scans are seen, and for how many iterations.
struct Level {
  int num_columns;
  double voxels;
  int num_iterations;
};
constexpr Level kCoarse{40, 8.0, 10}, kMiddle{80, 4.0, 20};  // as in the search around a guess

// A start is led on until a step moves the points by less than this part of the ball in which surfaces are estimated:
// what follows at full resolution sees more, and the comparison allows a ball.
constexpr double kSettledPerRadius = 0.02;

AlignOptions led_on_by(const Level& level, const ScanMatch& match, const Lengths& lengths) {
  AlignOptions options = match.usual_options();
  options.max_iterations = level.num_iterations;
  const double settled = kSettledPerRadius * lengths.radius;
  options.min_translation_step = std::max(options.min_translation_step, settled);
  options.min_rotation_step = std::max(options.min_rotation_step, settled / lengths.extent);
  return options;
}

// The most plausible starts as they are.
std::vector<Rigid3> most_plausible(const ScanMatch& match, std::span<const Rigid3> starts, int num_threads) {
  if (starts.size() <= kMaxSeedsLedOn) return {starts.begin(), starts.end()};
  std::vector<Hypothesis> all = as_they_are(match, starts, num_threads);
  std::stable_sort(all.begin(), all.end(),
                   [](const Hypothesis& a, const Hypothesis& b) { return a.plausibility > b.plausibility; });
  std::vector<Rigid3> best;
  for (const Hypothesis& start : std::span(all).first(kMaxSeedsLedOn)) best.push_back(start.target_from_source);
  return best;
}

std::vector<Rigid3> best_on(const Level& level, const ScanPair& pair, std::span<const Rigid3> starts,
                            const RegistrationOptions& options) {
  throw_if_stopped(options.stop);
  const PreparedPair scans = coarser(pair, level.num_columns, level.voxels, options.num_threads);
  const ScanMatch match(scans, options);
  const std::vector<Rigid3> kept = most_plausible(match, starts, options.num_threads);
  const AlignOptions by = led_on_by(level, match, pair.lengths);
  std::vector<Rigid3> best;
  for (const Hypothesis& found :
       best_of(led_on(match, kept, by), kMaxGlobalCandidates, pair.lengths.radius, kSameAngle))
    best.push_back(found.target_from_source);
  return best;
}

}  // namespace

GlobalStarts global_starts(const ScanPair& pair, const RegistrationOptions& options) {
  CandidateOptions candidates;
  const double voxel_size = kSeedVoxelPerRadius * pair.lengths.radius;
  candidates.voxel_size =
      std::max(feasible_voxel(pair.source.cloud, voxel_size), feasible_voxel(pair.target.cloud, voxel_size));
  candidates.num_threads = options.num_threads;
  candidates.stop = options.stop;
  std::vector<SeedPose> seeds = candidate_poses(pair.source.cloud, pair.target.cloud, candidates);
  std::vector<Rigid3> starts;
  starts.reserve(seeds.size());
  for (const SeedPose& pose : seeds) starts.push_back(pose.target_from_source);
  std::vector<Rigid3> kept = best_on(kCoarse, pair, starts, options);
  kept.insert(kept.end(), starts.begin(),
              starts.begin() + static_cast<std::ptrdiff_t>(std::min(kKeptBySupport, starts.size())));
  return {best_on(kMiddle, pair, kept, options), std::move(seeds)};
}

}  // namespace augicp
