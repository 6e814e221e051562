// SPDX-License-Identifier: MIT
// How LidarOdometry registers a scan: to the map from where it is expected, searched for, and again once straightened.
#include "augicp/odometry/lidar_attempt.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <utility>

#include "augicp/odometry/surface_agreement.h"
#include "augicp/odometry/sweep_kernel.h"
#include "augicp/registration/judge.h"
#include "augicp/registration/registration.h"
#include "augicp/trust/covariance.h"

namespace augicp {
namespace {

// Before any motion is known, the gate is this wide, voxels: a car moves by some metres between two scans.
constexpr double kFirstGate = 4.0;
constexpr double kMaxGate = 8.0;
constexpr double kGatePerError = 3.0;

// A gate wider than this many of the least ones is closed in two steps.
constexpr double kWideGate = 1.25;

// The kernel's least width, voxels: at the first step the right pairs are as far apart as the prediction is wrong.
constexpr double kMinKernel = 0.05;
constexpr double kKernelPerGate = 0.25;

// After a degenerate scan, where its pose is a prediction, a direction needs this many times the least information:
// a little would pull the next pose along what the last one left free.
constexpr double kObservabilityAfterDegenerate = 2.0;

constexpr int kMaxIterations = 40;
constexpr double kMinStepVoxels = 5e-4;
constexpr double kMinRotationStep = 5e-5;

// A sweep is straightened and registered again while the motion found moves its points by more than this, voxels: once,
// twice, three times. The motion found with a wrong one is still wrong by a part of it.
constexpr double kRedoVoxels[] = {0.01, 0.05, 0.05};

// A pose is near another up to this distance, voxels: a turn by a radian.
constexpr double kNearVoxels = kTypicalDistanceVoxels;

// A sensor that has moved by more than this since the last scan, voxels, does not stand still.
constexpr double kStillVoxels = 0.05;

}  // namespace

AlignOptions LidarOdometry::align_options() const {
  AlignOptions align_by;
  align_by.information = options_.parts.information;
  align_by.kernel_per_median = kKernelPerMedian;
  align_by.max_iterations = kMaxIterations;
  align_by.min_translation_step = kMinStepVoxels * voxel_size_;
  align_by.min_rotation_step = kMinRotationStep;
  align_by.num_threads = options_.num_threads;
  align_by.stop = options_.stop;
  align_by.gates.max_distance = options_.gate_voxels * voxel_size_;
  align_by.min_kernel_chi2 = std::pow(kMinKernel * voxel_size_, 2);
  align_by.min_observability = options_.min_observability * (is_last_degenerate_ ? kObservabilityAfterDegenerate : 1.0);
  return align_by;
}

void LidarOdometry::align_to_map(const Rigid3& guess, double gate, Attempt& attempt,
                                 const std::optional<FreeDirections>& free) const {
  AlignOptions align_by = align_options();
  align_by.free_directions = free;
  const double min_observability = align_by.min_observability;
  // A wide gate lets scans slide along what the last one left free, or where nothing is known yet.
  const bool holds_from_afar = !before_last_ || is_last_degenerate_;
  const double least = options_.gate_voxels * voxel_size_;
  const Cloud& target = matcher_->target();
  const std::unique_ptr<MatchSession> session = matcher_->session(attempt.source);
  attempt.world_from_sensor = guess;
  attempt.iterations = 0;
  for (bool is_last = false; !is_last; gate = least) {
    is_last = gate <= kWideGate * least;
    if (is_last) gate = least;
    align_by.gates.max_distance = gate;
    const double kernel = is_last ? kMinKernel * voxel_size_ : kKernelPerGate * gate;
    align_by.min_kernel_chi2 = kernel * kernel;
    align_by.min_observability = is_last || holds_from_afar ? min_observability : 0.0;
    attempt.result = align({attempt.source, *matcher_, *session},
                           without_origins(attempt.world_from_sensor, attempt.source, target), align_by);
    attempt.world_from_sensor = with_origins(attempt.result.target_from_source, attempt.source, target);
    attempt.iterations += attempt.result.iterations;
  }
  const Rigid3 pose = without_origins(attempt.world_from_sensor, attempt.source, target);
  const auto pairs = session->match(pose, align_by.gates, options_.num_threads);
  const SurfaceAgreement found =
      surface_agreement({attempt.source, target, pairs, pose}, options_.on_surface_voxels * voxel_size_);
  attempt.agreement = found.share, attempt.rmse = found.rmse;
}

// Of the pose that the last registration found. It takes as long as some iterations, so that only the last attempt gets
// it.
std::optional<Mat6d> LidarOdometry::covariance_of(const AlignResult& result, const Cloud& source) const {
  if (!has_pose(result.status) || result.status == AlignStatus::Degenerate) return std::nullopt;
  const PosedPairs posed{source, matcher_->target(), result.pairs, result.target_from_source};
  return covariance(*matcher_, {posed, align_options().gates, result.objective}, kCorrelationVoxels * voxel_size_,
                    result.observability.directions, options_.num_threads);
}

// Of a sensor that may stand still: what the mean of its poses needs is worth its time then.
bool LidarOdometry::is_near_last(const Attempt& attempt) const {
  return options_.parts.averages_standstill &&
         motion_between(last_->world_from_camera, attempt.world_from_sensor, typical_distance(voxel_size_)) <
             kStillVoxels * voxel_size_;
}

// The pose of a sensor that stands still is the mean of the last ones.
void LidarOdometry::settle(Attempt& attempt) {
  const std::optional<Mat6d> covariance = covariance_at_sensor(attempt);
  if (!covariance || !is_near_last(attempt))
    standstill_.forget();
  else
    attempt.world_from_sensor = standstill_.add(attempt.world_from_sensor, *covariance);
}

// A scan that is to be checked has its covariance, too.
bool LidarOdometry::wants_covariance() const { return options_.covariance || is_check_due(); }

bool LidarOdometry::is_check_due() const {
  return options_.check_every > 0 && num_since_check_ + 1 >= options_.check_every;
}

std::optional<DriftCheck> LidarOdometry::checked(const Attempt& attempt) const {
  if (!is_check_due()) return std::nullopt;
  SelfCheckOptions options;
  options.distance = options_.check_distance_voxels * voxel_size_;
  options.on_surface = options_.on_surface_voxels * voxel_size_;
  options.typical_distance = typical_distance(voxel_size_);
  options.align_by = align_options();
  options.align_by.correlation_length = kCorrelationVoxels * voxel_size_;
  return self_check_.check(attempt.source, attempt.world_from_sensor, covariance_at_sensor(attempt), options);
}

// A search takes as long as thirty scans. What the first two have not found, the third seldom finds: of lost scans in a
// row the first, second, fourth, eighth are searched for.
bool LidarOdometry::is_search_due() const {
  const auto number = static_cast<unsigned>(num_lost_ + 1);
  return std::has_single_bit(number);
}

// Registers to the last keyframe from many starts, and to the map from there. A pose far from the last one is believed
// only if both scans support it: in a room, a scan that its motion has bent fits half-turned as well as where it
// belongs.
void LidarOdometry::search(Attempt& attempt) const {
  RegistrationOptions registration;
  registration.num_threads = options_.num_threads;
  registration.stop = options_.stop;
  registration.covariance = false;
  const Rigid3 guess = inverse(keyframe_->world_from_sensor) * last_->world_from_camera;
  const AlignResult found =
      register_scans(scan_of(attempt.fine), scan_of(keyframe_->cloud), guess, registration).result;
  const Rigid3 pose = keyframe_->world_from_sensor * found.target_from_source;
  const bool is_supported = found.status == AlignStatus::Converged || found.status == AlignStatus::Degenerate;
  const double moved = motion_between(last_->world_from_camera, pose, typical_distance(voxel_size_));
  if (!has_pose(found.status) || (!is_supported && moved > kNearVoxels * voxel_size_)) return;
  Attempt other = attempt;
  align_to_map(pose, 2.0 * options_.gate_voxels * voxel_size_, other);
  if (other.agreement > attempt.agreement) attempt = std::move(other);
}

LidarOdometry::Attempt LidarOdometry::from(const Start& start, const Cloud& scan, const SweepShares& shares) const {
  Attempt attempt = prepared(scan, shares, start.motion);
  const double gate = std::min(start.gate_voxels, kMaxGate) * voxel_size_;
  align_to_map(start.world_from_sensor, gate, attempt);
  // What is free shows only where the gate is narrow, and before that the scan may have slid along it.
  const auto num_free = static_cast<int>(attempt.result.free_motions.size());
  const Rigid3 guess = without_origins(start.world_from_sensor, attempt.source, matcher_->target());
  if (!start.is_trusted || num_free == 0 || !has_left_along_free(attempt.result, guess)) return attempt;
  const int num_iterations = attempt.iterations;
  align_to_map(start.world_from_sensor, gate, attempt, FreeDirections{attempt.result.observability, num_free});
  attempt.iterations += num_iterations;
  return attempt;
}

// From where the prediction leads. If that does not convince, or the last motion is too old to tell, also from the last
// pose: the sensor may have stopped, or the stamps have jumped.
LidarOdometry::Attempt LidarOdometry::started(double stamp_s, const Cloud& scan, const SweepShares& shares) const {
  const Rigid3 guess = predicted(stamp_s);
  const double gate =
      before_last_ ? options_.gate_voxels + kGatePerError * prediction_error_ / voxel_size_ : kFirstGate;
  const bool is_trusted = before_last_ && spans_since_last(stamp_s) <= kTrustedSpans;
  Attempt attempt = from({guess, motion_of_sweep(stamp_s, guess), gate, is_trusted}, scan, shares);
  if (last_shown_) {  // its accelerations may have ended
    const Rigid3 even = predicted_evenly(stamp_s);
    Attempt evenly = from({even, motion_of_sweep(stamp_s, even), gate, is_trusted}, scan, shares);
    if (evenly.agreement > attempt.agreement) attempt = std::move(evenly);
  }
  if (!before_last_ || (is_convincing(stamp_s, attempt) && is_trusted)) return attempt;
  Attempt at_rest = from({last_->world_from_camera, SweepMotion{}, kFirstGate, false}, scan, shares);
  return at_rest.agreement > kClearGain * attempt.agreement ? at_rest : attempt;
}

LidarOdometry::Attempt LidarOdometry::registered(double stamp_s, const Cloud& scan, const SweepShares& shares) const {
  Attempt attempt = started(stamp_s, scan, shares);
  if (options_.search && !is_convincing(stamp_s, attempt) && is_search_due()) search(attempt);
  for (const double least_voxels : kRedoVoxels) {
    const SweepMotion found = motion_of_sweep(stamp_s, attempt.world_from_sensor);
    if (shares.empty() ||
        bending_between(*attempt.motion, found, typical_distance(voxel_size_)) < least_voxels * voxel_size_)
      break;
    Attempt again = straightened(attempt, scan, shares, found);
    align_to_map(attempt.world_from_sensor, options_.gate_voxels * voxel_size_, again);
    again.iterations += attempt.iterations;
    if (attempt.agreement > kClearGain * again.agreement) break;  // after a gap the mean motion may be wrong
    attempt = std::move(again);
  }
  return shares.empty() ? attempt : straightened_by_itself(std::move(attempt), stamp_s, scan, shares);
}

}  // namespace augicp
