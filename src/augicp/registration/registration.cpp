// SPDX-License-Identifier: MIT
#include "augicp/registration/registration.h"

#include <algorithm>
#include <array>
#include <utility>

#include "augicp/cloud/voxel_grid.h"
#include "augicp/core/parallel.h"
#include "augicp/core/stop.h"
#include "augicp/match/ray_spacing.h"
#include "augicp/registration/coarse_to_fine.h"
#include "augicp/registration/far_outliers.h"
#include "augicp/registration/final_pass.h"
#include "augicp/registration/finer_balls.h"
#include "augicp/registration/memory.h"
#include "augicp/registration/scan_match.h"
#include "augicp/registration/slid.h"
#include "augicp/surface/ball_neighbourhood.h"
#include "augicp/surface/gaussians.h"
#include "augicp/surface/intensity_gradient.h"
#include "augicp/surface/window_surface.h"

namespace augicp {
namespace {

// Spinning scanners sample a wall far away more thinly than a ball near the sensor expects.
constexpr std::size_t kMinBallPoints = 10;
constexpr double kMaxBallGrowth = 3.0;

constexpr double kReachPerExtent = 1000.0;

// What a scan still lacks of what its method needs.
struct Missing {
  bool surface, gaussians;

  bool any() const { return surface || gaussians; }
};
Missing missing_of(const Cloud& cloud, const RegistrationOptions& options) {
  return {!cloud.has_directions(), options.method == Method::Ndt && !cloud.has_gaussians()};
}

void estimate_in_windows(Scan& scan, Missing missing, const Lengths& lengths, const RegistrationOptions& options) {
  WindowOptions window;
  window.radius = lengths.radius;
  const IndexImage& index = scan.view->index;
  if (missing.surface) estimate_surface(scan.cloud, index, window, surface_options(options), options.num_threads);
  if (missing.gaussians)
    estimate_gaussians(scan.cloud, WindowNeighbourhood(scan.cloud, index, window, options.num_threads), lengths.radius,
                       options.num_threads);
}

void estimate_in_balls(ThinnedScan& thinned, Missing missing, const Lengths& lengths,
                       const RegistrationOptions& options) {
  Cloud& cloud = thinned.scan.cloud;
  const BallOptions ball{lengths.radius, kMinBallPoints, kMaxBallGrowth * lengths.radius};
  const BallNeighbourhood neighbourhood(cloud, *thinned.grid, ball, options.num_threads);
  thinned.grid.reset();
  throw_if_stopped(options.stop);
  if (missing.surface) estimate_surface(cloud, neighbourhood, surface_options(options), options.num_threads);
  if (missing.gaussians) estimate_gaussians(cloud, neighbourhood, lengths.radius, options.num_threads);
}

void estimate_missing(ThinnedScan& thinned, const Lengths& lengths, const RegistrationOptions& options) {
  Scan& scan = thinned.scan;
  const Missing missing = missing_of(scan.cloud, options);
  if (!missing.any()) return;
  if (scan.view)
    estimate_in_windows(scan, missing, lengths, options);
  else
    estimate_in_balls(thinned, missing, lengths, options);
}

void estimate_intensity_gradients(Scan& scan, const Lengths& lengths, int num_threads) {
  if (scan.view)
    estimate_intensity_gradients(scan.cloud, scan.view->index, lengths.radius, num_threads);
  else
    estimate_intensity_gradients(scan.cloud, lengths.radius, num_threads);
}

// The result of the loop, whose poses are between the clouds' points, between their frames.
AlignResult between_frames(AlignResult result, const Cloud& source, const Cloud& target) {
  result.target_from_source = with_origins(result.target_from_source, source, target);
  for (AlignIteration& iteration : result.history)
    iteration.target_from_source = with_origins(iteration.target_from_source, source, target);
  for (RunnerUp& other : result.runners_up)
    other.target_from_source = with_origins(other.target_from_source, source, target);
  for (FreeMotion& motion : result.free_motions) motion.point += target.origin;
  return result;
}

// What follows the first registration, whose poses are between the clouds' points.
Registration refined(Registration first, RawPair raw, const Guess& guess, const RegistrationOptions& options) {
  first = in_finer_balls(std::move(first), raw, guess, options);
  if (!options.final_pass) return first;
  return with_final_pass(std::move(first), std::move(raw), guess, options);
}

// The registration between the clouds' points.
Registration registered(PreparedPair pair, const Rigid3& guess, const RegistrationOptions& options) {
  std::optional<RawPair> raw = std::exchange(pair.raw, std::nullopt);
  AlignResult result = coarse_to_fine(pair, guess, options);
  Registration found{std::move(result), std::move(pair)};
  const Guess known = options.global ? Guess{} : guess;
  if (raw) found = refined(std::move(found), std::move(*raw), known, options);
  found.result = unless_slid(std::move(found.result), found.prepared, known, options);
  return found;
}

AlignResult nothing_found(const Rigid3& initial_target_from_source) {
  AlignResult nothing;
  nothing.target_from_source = initial_target_from_source;
  return nothing;
}

bool have_extent(const ScanPair& pair) {
  return !pair.source.cloud.empty() && !pair.target.cloud.empty() && pair.lengths.max_distance > 0.0;
}

// Without extent there are no lengths and no surface: empty, or all points in one place.
bool has_surface(const Cloud& cloud, const Lengths& lengths) { return lengths.radius > 0.0 && !cloud.empty(); }

ThinnedScan thinned(Scan scan, const Lengths& lengths, const RegistrationOptions& options) {
  throw_if_stopped(options.stop);
  const std::size_t num_read = scan.cloud.size();
  if (!options.intensity) scan.cloud.intensities.clear(), scan.cloud.intensity_gradients.clear();
  if (!has_surface(scan.cloud, lengths)) return {std::move(scan), num_read, std::nullopt};
  if (!scan.view) {
    drop_far_outliers(scan.cloud, kReachPerExtent * lengths.extent);
    scan.place_is_known = is_one_sensors_scan(scan.cloud, static_cast<float>(tolerance_of(scan, lengths).distance));
    scan.cloud = downsample(scan.cloud, feasible_voxel(scan.cloud, lengths.voxel_size));
  }
  if (options.preset == Preset::Paper) scan.cloud.weights.clear();
  std::optional<CellGrid> grid;
  if (!scan.view && missing_of(scan.cloud, options).any()) grid.emplace(scan.cloud, lengths.radius);
  return {std::move(scan), num_read, std::move(grid)};
}

Scan extended(ThinnedScan thinned, const Lengths& lengths, const RegistrationOptions& options) {
  throw_if_stopped(options.stop);
  Scan& scan = thinned.scan;
  if (!has_surface(scan.cloud, lengths)) return std::move(scan);
  estimate_missing(thinned, lengths, options);
  if (scan.cloud.has_intensities() && !scan.cloud.has_intensity_gradients())
    estimate_intensity_gradients(scan, lengths, options.num_threads);
  return std::move(scan);
}

}  // namespace

Scan prepare(Scan scan, const Lengths& lengths, const RegistrationOptions& options) {
  ThinnedScan few = thinned(std::move(scan), lengths, options);
  require_memory({&few}, lengths, options);
  return extended(std::move(few), lengths, options);
}

PreparedPair prepare_pair(Scan source, Scan target, const RegistrationOptions& options) {
  options.check();
  const Lengths lengths = lengths_for(source, target, options);
  std::optional<RawPair> raw;
  if (may_have_finer_balls(source, target, options)) raw = RawPair{source, target};
  const auto prepare_now = [&] { return prepare_both({std::move(source), std::move(target)}, lengths, options); };
  PreparedPair pair = reported(options.on_stage, Stage::Surfaces, prepare_now);
  pair.raw = std::move(raw);
  return pair;
}

PreparedPair prepare_both(RawPair raw, const Lengths& lengths, const RegistrationOptions& options) {
  RegistrationOptions of_half = options;
  of_half.num_threads = half_of_threads(options.num_threads);
  std::array<Scan, 2> scans{std::move(raw.source), std::move(raw.target)};
  std::array<ThinnedScan, 2> few;
  const auto thin_one = [&](std::size_t k, std::size_t) { few[k] = thinned(std::move(scans[k]), lengths, of_half); };
  for_each_block(2, options.num_threads, thin_one, 1);
  require_memory({&few[0], &few[1]}, lengths, options);
  const auto extend_one = [&](std::size_t k, std::size_t) { scans[k] = extended(std::move(few[k]), lengths, of_half); };
  for_each_block(2, options.num_threads, extend_one, 1);
  return {std::move(scans[0]), std::move(scans[1]), lengths};
}

AlignResult register_prepared(const ScanPair& pair, const Rigid3& initial_target_from_source,
                              const RegistrationOptions& options) {
  is_projective(pair.target, options.association);  // throws where it cannot be
  const Cloud &source = pair.source.cloud, &target = pair.target.cloud;
  if (!have_extent(pair)) return nothing_found(initial_target_from_source);
  const Rigid3 guess = without_origins(initial_target_from_source, source, target);
  AlignResult found = coarse_to_fine(pair, guess, options);
  found = unless_slid(std::move(found), pair, options.global ? Guess{} : Guess{guess}, options);
  return between_frames(std::move(found), source, target);
}

Registration register_pair(PreparedPair pair, const Rigid3& initial_target_from_source,
                           const RegistrationOptions& options) {
  options.check();
  is_projective(pair.target, options.association);  // throws where it cannot be
  if (!have_extent(pair)) return {nothing_found(initial_target_from_source), std::move(pair)};
  const Rigid3 guess = without_origins(initial_target_from_source, pair.source.cloud, pair.target.cloud);
  Registration found = registered(std::move(pair), guess, options);
  found.result = between_frames(std::move(found.result), found.prepared.source.cloud, found.prepared.target.cloud);
  return found;
}

Registration register_scans(Scan source, Scan target, const Rigid3& initial_target_from_source,
                            const RegistrationOptions& options) {
  return register_pair(prepare_pair(std::move(source), std::move(target), options), initial_target_from_source,
                       options);
}

std::vector<FoundPose> find_pose(Scan source, Scan target, RegistrationOptions options) {
  options.global = true;
  PreparedPair pair = prepare_pair(std::move(source), std::move(target), options);
  is_projective(pair.target, options.association);  // throws where it cannot be
  if (!have_extent(pair)) return {};
  std::optional<RawPair> raw = std::exchange(pair.raw, std::nullopt);
  std::vector<FoundPose> found;
  for (AlignResult& result : from_anywhere(pair, options)) found.push_back({std::move(result), pair.lengths});
  if (found.empty()) return found;
  Registration best{std::move(found.front().result), std::move(pair)};
  if (raw) best = refined(std::move(best), std::move(*raw), {}, options);
  found.front() = {unless_slid(std::move(best.result), best.prepared, {}, options), best.prepared.lengths};
  const Cloud &source_cloud = best.prepared.source.cloud, &target_cloud = best.prepared.target.cloud;
  for (auto& [result, lengths] : found) result = between_frames(std::move(result), source_cloud, target_cloud);
  return found;
}

}  // namespace augicp
