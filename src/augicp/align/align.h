// SPDX-License-Identifier: MIT
#pragma once

#include <limits>
#include <optional>
#include <stop_token>
#include <vector>

#include "augicp/match/matcher.h"
#include "augicp/objective/linearize.h"
#include "augicp/trust/free_motions.h"
#include "augicp/trust/observability.h"
#include "augicp/trust/verdict.h"

namespace augicp {

// What is known of the motions that the data leave free.
struct FreeDirections {
  Observability seen;  // its first num_free directions are free
  int num_free = 0;
};

struct AlignOptions {
  InformationModel information = default_information();
  Gates gates;

  // The distance gate closes as the clouds meet: to this many times the median distance of the last iteration's pairs,
  // at least min_max_distance (metres). It never opens again. Infinity: it stays unchanged. Without it, parts of the
  // source that the target never saw keep pulling from as far as the first gate reaches.
  double gate_per_median = std::numeric_limits<double>::infinity();
  double min_max_distance = 0.0;

  // Weight of the linear part of the error against the position, see with_lever(). If set: fixed; 1 m is Table 2 as
  // printed. If not set: measured in each iteration as the ratio of the median errors of positions and directions, at
  // most max_lever (metres). The limit is needed because directions of pairs far apart have less meaning too.
  std::optional<double> lever;
  double max_lever = std::numeric_limits<double>::infinity();

  // K of Eq. (13). If not set: this many times the median chi2 of each iteration's pairs, so that it is wide while the
  // clouds are apart and narrow when they meet.
  std::optional<double> kernel_chi2;
  double kernel_per_median = 8.0;

  // The quantile of chi2 that stands for its median there, in (0, 0.5]. A half allows as many false pairs as true ones.
  // If nine of ten may be false, the median is the error of a false pair, and a far lower quantile is not.
  double kernel_quantile = 0.5;

  // Lower limit of K. Without it, a perfect fit of most pairs would silence the rest. In registration it is the chi2 of
  // a hundredth of the ball radius off a plane.
  double min_kernel_chi2 = 0.0;

  // The kernel of the direction's part alone, as a multiple of its own median. Most directions of wrong pairs are
  // random: they show no rotation, and would only slow the first steps. Infinity: off, as in the paper.
  double kernel_direction_per_median = 1.0;

  // Weight of a typical error of the intensity against a typical one of the position, if the clouds have intensities,
  // see weigh_intensities(). 0: off. With it the loop runs twice: without intensities, and from there with them.
  double intensity_weight = 0.0;

  // The kernel of the intensity's part, as a multiple of its own median: gloss, and what only one of the sensors sees,
  // is far above.
  double kernel_intensity_per_median = 4.0;

  // lambda of Eq. (10), relative to the mean diagonal of H's translation block and of its rotation block.
  double damping = 1e-6;

  int max_iterations = 50;

  // How many times longer the steps of a loop that creeps may be made, see stretch.h. 1: off, as in the paper.
  double max_stretch = 1.0;

  // A step below both ends the loop: metres and radians.
  double min_translation_step = 1e-5;
  double min_rotation_step = 1e-5;

  // If the information of the weakest direction, relative to the best one, is below this, the status is Degenerate.
  // Twelve generated shapes with free motions stay below 1e-4 with noise; right poses of fr1/desk are above in 99 of
  // 100 cases.
  double min_observability = 1.2e-4;

  // If set, no information is asked: these directions are free, and all others are not. The pose does not move along
  // the free ones, and the status is Degenerate if there are any.
  std::optional<FreeDirections> free_directions;

  // Residuals of points closer than this to each other may be correlated, metres; see covariance.h. 0: no covariance.
  double correlation_length = 0.0;

  int num_threads = 0;  // 0: all of the machine

  // Checked before each iteration: align() throws Interrupted once any thread requests an end.
  std::stop_token stop{};

  // Throws std::invalid_argument naming the first option out of its range.
  void check() const;
};

struct AlignIteration {
  Rigid3 target_from_source;  // after the iteration's step
  std::int64_t num_pairs = 0;
  double cost = 0.0;                   // before the step
  double kernel_chi2 = 0.0;            // K used
  double lever = 0.0;                  // used, metres; 0 if no direction was compared
  double intensity_information = 0.0;  // used; 0 if no intensity was compared
};

// Poses and places are between the clouds' points, without their origins; register_scans() gives them between the
// clouds' frames. On failure the last pose reached is kept: it is never replaced by the identity.
struct AlignResult {
  Rigid3 target_from_source;
  AlignStatus status = AlignStatus::TooFewPairs;
  int iterations = 0;
  std::int64_t num_pairs = 0;            // at the last iteration
  std::int64_t num_intensity_pairs = 0;  // of these, with compared intensities; 0: the clouds have none, or it is off
  double overlap = 0.0;                  // share of source points with a partner, in [0, 1]
  double rmse = 0.0;                     // of the distances within the pairs of the final pose, metres
  Mat6d information = Mat6d::Zero();     // H of the last iteration; order tx ty tz rx ry rz, target points' frame, left
  Observability observability;           // of the last iteration's pairs

  // Of the pose, in the order and on the side of `information`; see covariance.h. Present only if all six directions
  // are constrained, and no small step away from the pose lowers the cost.
  std::optional<Mat6d> covariance;

  // If the status is Degenerate: the motions that the data do not constrain. Along them the pose stays at the guess.
  std::vector<FreeMotion> free_motions;

  Objective objective;  // of the last iteration: with Gates, `pairs` and the pose what covariance() needs

  // Evidence for and against the pose. align() alone gathers none: its Converged means only that the steps are small.
  // register_prepared() judges, see registration/judge.h.
  std::optional<Evidence> evidence;
  std::vector<Doubt> doubts;

  // If the status is Ambiguous: other poses that the evidence supports, the best first. register_prepared() looks for
  // them between clouds.
  std::vector<RunnerUp> runners_up;

  // Those of the last iteration, in the order of the source's points.
  std::vector<Correspondence> pairs;

  std::vector<AlignIteration> history;
};

// Section 3.3: pairs, errors, weights, H and b, one damped step; repeated until the step is small. Thread safety:
// concurrent calls are independent. Poses are between the
// clouds' points, without their origins. Throws std::invalid_argument for options out of their range or if the target
// lacks the Gaussians that the information model weighs by, Interrupted where an end was requested.
AlignResult align(const Cloud& source, const Matcher& matcher, const Rigid3& initial_target_from_source,
                  const AlignOptions& options);

// Clouds that are aligned more than once, with what their session remembers from one time to the next.
struct KnownClouds {
  const Cloud& source;
  const Matcher& matcher;
  MatchSession& session;  // of this matcher, for this source
};

// The same result, sooner.
AlignResult align(const KnownClouds& clouds, const Rigid3& initial_target_from_source, const AlignOptions& options);

}  // namespace augicp
