// SPDX-License-Identifier: MIT
#include "augicp/registration/registration.h"

#include <algorithm>
#include <utility>

#include "augicp/cloud/voxel_grid.h"
#include "augicp/core/parallel.h"
#include "augicp/core/stop.h"
#include "augicp/match/ray_spacing.h"
#include "augicp/registration/coarse_to_fine.h"
#include "augicp/registration/final_pass.h"
#include "augicp/registration/scan_match.h"
#include "augicp/surface/ball_neighbourhood.h"
#include "augicp/surface/gaussians.h"
#include "augicp/surface/intensity_gradient.h"
#include "augicp/surface/window_surface.h"

namespace augicp {
namespace {

// Spinning scanners sample a wall far away more thinly than a ball near the sensor expects.
constexpr std::size_t kMinBallPoints = 10;
constexpr double kMaxBallGrowth = 3.0;

// Far outliers (a single "no reading" at zero in a cloud of UTM coordinates) belong to no scene and would only stretch
// the grid.
constexpr double kReachPerExtent = 1000.0;
void drop_far_outliers(Cloud& cloud, double extent) {
  const auto reach = static_cast<float>(kReachPerExtent * extent);
  if (bounds(cloud).diagonal() <= static_cast<double>(reach)) return;  // the median point lies within
  const Vec3f centre = median_point(cloud);
  std::vector<std::uint32_t> within;
  for (std::uint32_t i = 0; i < cloud.size(); ++i)
    if ((cloud.points[i] - centre).norm() <= reach) within.push_back(i);
  if (within.size() < cloud.size()) cloud = select(cloud, within);
}

// What a scan still lacks of what its method needs.
struct Missing {
  bool surface, gaussians;
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

void estimate_in_balls(Cloud& cloud, Missing missing, const Lengths& lengths, const RegistrationOptions& options) {
  const BallOptions ball{lengths.radius, kMinBallPoints, kMaxBallGrowth * lengths.radius};
  const BallNeighbourhood neighbourhood(cloud, ball, options.num_threads);
  throw_if_stopped(options.stop);
  if (missing.surface) estimate_surface(cloud, neighbourhood, surface_options(options), options.num_threads);
  if (missing.gaussians) estimate_gaussians(cloud, neighbourhood, lengths.radius, options.num_threads);
}

void estimate_missing(Scan& scan, const Lengths& lengths, const RegistrationOptions& options) {
  const Missing missing = missing_of(scan.cloud, options);
  if (!missing.surface && !missing.gaussians) return;
  if (scan.view)
    estimate_in_windows(scan, missing, lengths, options);
  else
    estimate_in_balls(scan.cloud, missing, lengths, options);
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

// The registration between the clouds' points.
Registration registered(PreparedPair pair, const Rigid3& guess, const RegistrationOptions& options) {
  std::optional<RawPair> raw = std::exchange(pair.raw, std::nullopt);
  AlignResult result = coarse_to_fine(pair, guess, options);
  Registration first{std::move(result), std::move(pair)};
  if (!raw) return first;
  return with_final_pass(std::move(first), std::move(*raw), options.global ? Guess{} : guess, options);
}

AlignResult nothing_found(const Rigid3& initial_target_from_source) {
  AlignResult nothing;
  nothing.target_from_source = initial_target_from_source;
  return nothing;
}

bool have_extent(const ScanPair& pair) {
  return !pair.source.cloud.empty() && !pair.target.cloud.empty() && pair.lengths.max_distance > 0.0;
}

}  // namespace

Scan prepare(Scan scan, const Lengths& lengths, const RegistrationOptions& options) {
  throw_if_stopped(options.stop);
  if (!options.intensity) scan.cloud.intensities.clear(), scan.cloud.intensity_gradients.clear();
  // Without extent there are no lengths and no surface: empty, or all points in one place.
  if (!(lengths.radius > 0.0) || scan.cloud.empty()) return scan;
  if (!scan.view) {
    drop_far_outliers(scan.cloud, lengths.extent);
    scan.place_is_known = is_one_sensors_scan(scan.cloud);
    scan.cloud = downsample(scan.cloud, feasible_voxel(scan.cloud, lengths.voxel_size));
  }
  if (options.preset == Preset::Paper) scan.cloud.weights.clear();
  throw_if_stopped(options.stop);
  estimate_missing(scan, lengths, options);
  if (scan.cloud.has_intensities() && !scan.cloud.has_intensity_gradients())
    estimate_intensity_gradients(scan, lengths, options.num_threads);
  return scan;
}

PreparedPair prepare_pair(Scan source, Scan target, const RegistrationOptions& options) {
  options.check();
  const Lengths lengths = lengths_for(source, target, options);
  std::optional<RawPair> raw;
  if (may_have_final_pass(source, target, options)) raw = RawPair{source, target};
  PreparedPair pair = prepare_both({std::move(source), std::move(target)}, lengths, options);
  pair.raw = std::move(raw);
  return pair;
}

PreparedPair prepare_both(RawPair raw, const Lengths& lengths, const RegistrationOptions& options) {
  PreparedPair pair{std::move(raw.source), std::move(raw.target), lengths};
  RegistrationOptions of_half = options;  // of the threads
  if (options.num_threads > 1) of_half.num_threads = options.num_threads / 2;
  const auto prepare_one = [&](std::size_t which, std::size_t) {
    Scan& scan = which == 0 ? pair.source : pair.target;
    scan = prepare(std::move(scan), lengths, of_half);
  };
  for_each_block(2, options.num_threads, prepare_one, 1);
  return pair;
}

AlignResult register_prepared(const ScanPair& pair, const Rigid3& initial_target_from_source,
                              const RegistrationOptions& options) {
  is_projective(pair.target, options.association);  // throws where it cannot be
  const Cloud &source = pair.source.cloud, &target = pair.target.cloud;
  if (!have_extent(pair)) return nothing_found(initial_target_from_source);
  const Rigid3 guess = without_origins(initial_target_from_source, source, target);
  return between_frames(coarse_to_fine(pair, guess, options), source, target);
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

std::vector<AlignResult> find_pose(Scan source, Scan target, RegistrationOptions options) {
  options.global = true;
  PreparedPair pair = prepare_pair(std::move(source), std::move(target), options);
  is_projective(pair.target, options.association);  // throws where it cannot be
  if (!have_extent(pair)) return {};
  std::optional<RawPair> raw = std::exchange(pair.raw, std::nullopt);
  std::vector<AlignResult> found = from_anywhere(pair, options);
  if (!found.empty() && raw)
    found.front() = with_final_pass({found.front(), pair}, std::move(*raw), std::nullopt, options).result;
  for (AlignResult& result : found) result = between_frames(std::move(result), pair.source.cloud, pair.target.cloud);
  return found;
}

}  // namespace augicp
