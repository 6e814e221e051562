// SPDX-License-Identifier: MIT
#include "augicp/experiment/synthetic.h"

#include <algorithm>

#include "augicp/align/damped_step.h"
#include "augicp/align/weighing.h"
#include "augicp/core/check.h"
#include "augicp/experiment/pose_error.h"
#include "augicp/surface/ball_neighbourhood.h"
#include "augicp/surface/gaussians.h"

namespace augicp {
namespace {

// Smaller steps are lost in the last digits of float points: the pose no longer moves.
constexpr double kNoStep = 1e-12;

// NDT has the Gaussians of the corrupted target's points in balls of the registration's radius.
void add_gaussians(Cloud& target, const Lengths& lengths, int num_threads) {
  const BallNeighbourhood neighbourhood(target, {lengths.radius, 0, 0.0}, num_threads);
  estimate_gaussians(target, neighbourhood, lengths.radius, num_threads);
}

Lengths lengths_of(const KnownPairs& known) { return derive_lengths(scan_of(known.source), scan_of(known.target)); }

AlignOptions options_for(Method method, const KnownPairs& known, const SyntheticOptions& options) {
  RegistrationOptions registration;
  registration.preset = options.preset;
  registration.method = method;
  registration.kernel_chi2 = options.kernel_chi2;
  registration.num_threads = options.num_threads;
  return known_pairs_options(lengths_of(known), registration);
}

// The iteration of section 3.3 without the search for pairs: the errors of the guess and after each iteration.
std::vector<PoseError> run_known_pairs(const KnownPairs& known, const AlignOptions& align,
                                       const SyntheticOptions& options) {
  Rigid3 pose;
  std::vector<PoseError> errors{pose_error(pose, known.target_from_source)};
  for (int i = 0; i < options.iterations; ++i) {
    const PairChi2 chi2 =
        chi2_of_pairs({known.source, known.target, known.pairs, pose}, align.information, options.num_threads);
    const Weighing weighing = weigh_pairs(chi2, align);
    const Objective objective{with_lever(align.information, weighing.lever), weighing.kernel_chi2,
                              weighing.kernel_direction_chi2};
    const NormalEquations equations =
        linearize({known.source, known.target, known.pairs, pose}, objective, options.num_threads);
    const Vec6d step = damped_step(equations, align.damping);
    pose = retract(pose, step);
    errors.push_back(pose_error(pose, known.target_from_source));
    if (step.norm() < kNoStep) break;
  }
  errors.resize(static_cast<std::size_t>(options.iterations) + 1, errors.back());
  return errors;
}

// [method][seed][iteration]
using Errors = std::vector<std::vector<std::vector<PoseError>>>;

Errors run_corruption(KnownPairsOptions scene, const SyntheticOptions& options, const std::function<void()>& on_run) {
  Errors errors(options.methods.size());
  for (unsigned i = 0; i < options.num_seeds; ++i) {
    scene.seed = options.first_seed + i;
    KnownPairs known = make_known_pairs(scene);
    if (std::count(options.methods.begin(), options.methods.end(), Method::Ndt) > 0)
      add_gaussians(known.target, lengths_of(known), options.num_threads);
    for (std::size_t m = 0; m < options.methods.size(); ++m)
      errors[m].push_back(run_known_pairs(known, options_for(options.methods[m], known, options), options));
    on_run();
  }
  return errors;
}

MeanInterval over_seeds(const std::vector<std::vector<PoseError>>& errors, std::size_t iteration,
                        double PoseError::*which) {
  std::vector<double> values;
  for (const std::vector<PoseError>& of_seed : errors) values.push_back(of_seed[iteration].*which);
  return mean_interval(values);
}

void append_rows(const KnownPairsOptions& scene, const Errors& errors, const SyntheticOptions& options,
                 std::vector<SyntheticRow>& rows) {
  for (std::size_t m = 0; m < options.methods.size(); ++m)
    for (int i = 0; i <= options.iterations; ++i)
      rows.push_back({scene.outlier_share, scene.point_noise_m, scene.normal_noise_rad, options.methods[m], i,
                      over_seeds(errors[m], i, &PoseError::translation),
                      over_seeds(errors[m], i, &PoseError::rotation)});
}

}  // namespace

void SyntheticOptions::check() const {
  require(num_points >= 6, "num_points", static_cast<double>(num_points), "must be at least 6");
  for (const double share : outlier_shares)
    require(share >= 0.0 && share <= 1.0, "outlier_shares", share, "must be in [0, 1]");
  for (const double noise : point_noises) require_not_negative("point_noises", noise);
  for (const double noise : normal_noises_rad) require_not_negative("normal_noises", noise);
  require(iterations > 0, "iterations", iterations, "must be at least 1");
  require(num_seeds > 0, "num_seeds", num_seeds, "must be at least 1");
  if (kernel_chi2) require(*kernel_chi2 > 0.0, "kernel_chi2", *kernel_chi2, "must be above 0");
  require(num_threads >= 0, "num_threads", num_threads, "must be at least 0 (0: all)");
}

std::size_t num_runs(const SyntheticOptions& options) {
  return options.outlier_shares.size() * options.point_noises.size() * options.normal_noises_rad.size() *
         options.num_seeds;
}

std::vector<SyntheticRow> run_synthetic(const SyntheticOptions& options, const std::function<void()>& on_run) {
  options.check();
  std::vector<SyntheticRow> rows;
  for (const double outlier_share : options.outlier_shares)
    for (const double point_noise : options.point_noises)
      for (const double normal_noise_rad : options.normal_noises_rad) {
        const KnownPairsOptions scene{options.num_points, outlier_share, point_noise, normal_noise_rad, 0};
        append_rows(scene, run_corruption(scene, options, on_run), options, rows);
      }
  return rows;
}

}  // namespace augicp
