// SPDX-License-Identifier: MIT
#pragma once

#include <limits>
#include <optional>
#include <stop_token>
#include <vector>

#include "augicp/match/matcher.h"
#include "augicp/trust/free_motions.h"
#include "augicp/trust/observability.h"
#include "augicp/trust/verdict.h"

namespace augicp {

struct AlignOptions {
  InformationModel information = default_information();
  Gates gates;

  // The gate on distance closes as the clouds meet: to this many times the median distance within the last iteration's
  // pairs, but not below min_max_distance (metres), and never opens again. Infinity: it stays as it is. Without it,
  // parts of the source that the target never saw keep pulling from as far as the first gate reaches.
  double gate_per_median = std::numeric_limits<double>::infinity();
  double min_max_distance = 0.0;

  // How the linear part of the error weighs against the position, see with_lever(). Set: fixed, and 1 m is Table 2 as
  // printed. Not set: what the pairs of each iteration show, the ratio of the median errors of positions and
  // directions, but at most max_lever (metres): the farther apart the clouds, the less a pair's direction says too.
  std::optional<double> lever;
  double max_lever = std::numeric_limits<double>::infinity();

  // K of Eq. (13). Not set: this many times the median chi2 of the pairs of each iteration, so that it is wide while
  // the clouds lie apart and narrow when they meet.
  std::optional<double> kernel_chi2;
  double kernel_per_median = 8.0;

  // But K never falls below this, or a perfect fit of most pairs would silence the rest. In registration it is what a
  // hundredth of the ball's radius off a plane costs.
  double min_kernel_chi2 = 0.0;

  // The kernel of the direction's part alone, as many times its own median. Most directions of wrong pairs are random:
  // they show no rotation, and would only hold the first steps back. Infinity: off, as in the paper.
  double kernel_direction_per_median = 1.0;

  // How much a typical error of the intensity counts beside a typical one of the position, where the clouds have
  // intensities, see weigh_intensities(). 0: off. The loop then runs twice: without intensities, and from there with
  // them.
  double intensity_weight = 0.0;

  // The kernel of the intensity's part, as many times its own median: what shines, or is seen by one of the sensors
  // only, lies far above.
  double kernel_intensity_per_median = 4.0;

  // lambda of Eq. (10), as a part of the mean diagonal of H's translation and rotation block each.
  double damping = 1e-6;

  int max_iterations = 50;

  // A step below both ends the loop: metres and radians.
  double min_translation_step = 1e-5;
  double min_rotation_step = 1e-5;

  // Where the weakest direction's part of the best one's information is below, the status is Degenerate. Twelve
  // generated shapes that leave a motion open stay below 1e-4 with noise, right poses of fr1/desk are above in 99 of
  // 100 cases.
  double min_observability = 1.2e-4;

  // Errors of points nearer to each other than this may hang together, metres; see covariance.h. 0: no covariance.
  double correlation_length = 0.0;

  int num_threads = 0;  // 0: all the machine's

  // Asked before each iteration: align() throws Interrupted once an end is requested, from any thread.
  std::stop_token stop{};

  // Throws std::invalid_argument naming the first option out of its range.
  void check() const;
};

struct AlignIteration {
  Rigid3 target_from_source;  // after the iteration's step
  std::int64_t num_pairs = 0;
  double cost = 0.0;                   // before the step
  double kernel_chi2 = 0.0;            // K used
  double lever = 0.0;                  // used, metres; 0 where no direction was compared
  double intensity_information = 0.0;  // used; 0 where no intensity was compared
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

  // Of the pose, in the order and on the side of `information`; see covariance.h. Only where all six directions are
  // held, and the pose is a minimum among those a small step away.
  std::optional<Mat6d> covariance;

  // Where the status is Degenerate: the motions that the data leave open. The pose has not moved along them from the
  // guess.
  std::vector<FreeMotion> free_motions;

  // What speaks for the pose and against it. align() alone gathers none: its Converged says that the steps became
  // small, and no more; register_prepared() judges, see registration/judge.h.
  std::optional<Evidence> evidence;
  std::vector<Doubt> doubts;

  // Those of the last iteration, in the order of the source's points.
  std::vector<Correspondence> pairs;

  std::vector<AlignIteration> history;
};

// Section 3.3: pairs, errors, weights, H and b, one damped step; again, until the step is small. Poses are between the
// clouds' points, without their origins. Throws std::invalid_argument for options out of their range, Interrupted where
// an end was requested.
AlignResult align(const Cloud& source, const Matcher& matcher, const Rigid3& initial_target_from_source,
                  const AlignOptions& options);

}  // namespace augicp
