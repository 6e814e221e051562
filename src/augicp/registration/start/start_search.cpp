// SPDX-License-Identifier: MIT
#include "augicp/registration/start/start_search.h"

#include <algorithm>
#include <limits>
#include <span>

#include "augicp/core/angles.h"
#include "augicp/core/parallel.h"
#include "augicp/registration/judge.h"
#include "augicp/registration/start/lead_on.h"
#include "augicp/registration/thin_scan.h"

namespace augicp {
namespace {

// Size of the second level.
constexpr int kMiddleColumns = 80;
constexpr double kMiddleVoxels = 4.0;

// On images an alignment finds its way from some 10 degrees, farther turned images soon see nothing in common. Clouds
// may have been seen all around.
const std::vector<double> kTurnsOfImages{17.0 * kRadPerDeg, 34.0 * kRadPerDeg, 51.0 * kRadPerDeg};
const std::vector<double> kTurnsOfClouds{20.0 * kRadPerDeg, 40.0 * kRadPerDeg,  60.0 * kRadPerDeg,
                                         90.0 * kRadPerDeg, 130.0 * kRadPerDeg, 180.0 * kRadPerDeg};
const std::vector<double> kTurnsOfPulled{40.0 * kRadPerDeg};

// Above, the guess is taken to have led to the right pose and nothing else is tried; see plausibility().
constexpr double kConvincing = 0.5;

constexpr std::size_t kMaxCandidates = 4;
constexpr double kOwnAngle = 8.5 * kRadPerDeg;  // half of the smallest turn: what is nearer came from the guess
constexpr int kImageIterations = 10, kCloudIterations = 20, kMiddleIterations = 20;

// Without a camera, points far off have no partner on their line of sight, only the nearest: far gates, pairs whatever
// their directions, and information almost alike in all directions let it pull clouds together from afar.
constexpr double kWideGate = 4.0;
constexpr double kWideEpsilon = 0.3;

AlignOptions image_options(const ScanMatch& level) {
  AlignOptions coarse = level.usual_options();
  coarse.max_iterations = kImageIterations;
  return coarse;
}

AlignOptions cloud_options(const ScanMatch& level, const RegistrationOptions& options) {
  AlignOptions coarse = level.usual_options();
  coarse.max_iterations = kCloudIterations;
  coarse.information = information_for(options, kWideEpsilon);  // of the target: from afar directions do not agree yet
  coarse.kernel_chi2 = options.kernel_chi2;
  coarse.gates.max_distance *= kWideGate;
  coarse.gates.max_angle = std::numeric_limits<double>::infinity();
  coarse.gate_per_median = std::numeric_limits<double>::infinity();
  return coarse;
}

// About what a scan is turned: its sensor, or the middle of its points.
Vec3d pivot_of(const Scan& scan, const Lengths& lengths) {
  return sensor_place(scan, lengths).value_or(median_point(scan.cloud)).cast<double>();
}

bool is_convincing(const std::vector<Hypothesis>& hypotheses) {
  return std::any_of(hypotheses.begin(), hypotheses.end(),
                     [](const Hypothesis& hypothesis) { return hypothesis.plausibility > kConvincing; });
}

// The first start is the guess: where it convinces the others are not tried.
std::vector<Hypothesis> led_on_from_guess(const ScanMatch& level, std::span<const Rigid3> starts,
                                          const AlignOptions& options) {
  std::vector<Hypothesis> found = led_on(level, starts.first(1), options);
  if (is_convincing(found)) return found;
  const auto others = led_on(level, starts.subspan(1), options);
  found.insert(found.end(), others.begin(), others.end());
  return found;
}

// Where lines of sight lead nowhere, nearest points may: they pull two images together from half a metre, though not
// always to where they belong. So they only propose starts.
std::vector<Rigid3> pulled_together(const ScanMatch& coarse, std::vector<Rigid3> starts, RegistrationOptions options) {
  options.association = Association::Nearest;
  const Scan source = scan_of(coarse.scans().source.cloud), target = scan_of(coarse.scans().target.cloud);
  const ScanMatch nearest({source, target, coarse.scans().lengths}, options);
  const AlignOptions by = on_one_thread(cloud_options(nearest, options));
  const auto pull = [&](std::size_t k, std::size_t) { starts[k] = nearest.align(starts[k], by).target_from_source; };
  for_each_block(starts.size(), options.num_threads, pull, 1);
  return starts;
}

// Wide gates find clouds that lie far apart. Where the clouds overlap in part only, wide gates pull together what does
// not belong together, and the usual ones find the pose.
std::vector<Hypothesis> cloud_hypotheses(const ScanMatch& coarse, std::span<const Rigid3> starts,
                                         const RegistrationOptions& options) {
  std::vector<Hypothesis> found = led_on(coarse, starts, cloud_options(coarse, options));
  AlignOptions narrow = coarse.usual_options();
  narrow.max_iterations = kCloudIterations;
  const auto others = led_on(coarse, starts, narrow);
  found.insert(found.end(), others.begin(), others.end());
  return found;
}

std::vector<Hypothesis> coarse_hypotheses(const ScanMatch& coarse, const Rigid3& guess,
                                          const RegistrationOptions& options) {
  const Scan &source = coarse.scans().source, &target = coarse.scans().target;
  const bool has_images = source.view && target.view;
  const Vec3d pivot = guess * pivot_of(source, coarse.scans().lengths);
  const std::vector<Rigid3> starts = turned(guess, pivot, has_images ? kTurnsOfImages : kTurnsOfClouds);
  if (!is_projective(target, options.association)) return cloud_hypotheses(coarse, starts, options);
  const AlignOptions by = image_options(coarse);
  std::vector<Hypothesis> found = led_on_from_guess(coarse, starts, by);
  if (is_convincing(found)) return found;
  const auto pulled = pulled_together(coarse, turned(guess, pivot, kTurnsOfPulled), options);
  const auto led = led_on_from_guess(coarse, pulled, by);
  found.insert(found.end(), led.begin(), led.end());
  return found;
}

}  // namespace

std::vector<Rigid3> search_starts(const ScanPair& pair, const Rigid3& guess_target_from_source,
                                  const RegistrationOptions& options) {
  const PreparedPair coarse = coarser(pair, kCoarseColumns, kCoarseVoxels, options.num_threads);
  const std::vector<Hypothesis> candidates =
      best_of(coarse_hypotheses(ScanMatch(coarse, options), guess_target_from_source, options), kMaxCandidates,
              pair.lengths.radius, kSameAngle);
  if (candidates.empty()) return {guess_target_from_source};
  const PreparedPair scans = coarser(pair, kMiddleColumns, kMiddleVoxels, options.num_threads);
  const ScanMatch middle(scans, options);
  AlignOptions by = middle.usual_options();
  by.max_iterations = kMiddleIterations;
  std::vector<Rigid3> starts;
  for (const Hypothesis& candidate : candidates) starts.push_back(candidate.target_from_source);
  const auto best = best_of(led_on(middle, starts, by), kMaxCandidates, pair.lengths.radius, kSameAngle);
  // Before a wall the guess says what the wall does not, and must not be taken along by few and noisy points.
  const bool is_guess = best.empty() || (best.front().is_free && angle_between(best.front().target_from_source,
                                                                               guess_target_from_source) < kOwnAngle);
  if (is_guess) return {guess_target_from_source};
  starts.clear();
  for (const Hypothesis& hypothesis : best) starts.push_back(hypothesis.target_from_source);
  return starts;
}

}  // namespace augicp
