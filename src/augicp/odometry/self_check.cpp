// SPDX-License-Identifier: MIT
#include "augicp/odometry/self_check.h"

#include <cmath>
#include <utility>

#include "augicp/cloud/voxel_grid.h"
#include "augicp/core/angles.h"
#include "augicp/odometry/surface_agreement.h"
#include "augicp/trust/covariance.h"

namespace augicp {
namespace {

// Of the scan, evenly chosen: the direct registration takes half of the time of one to the map then.
constexpr std::size_t kMaxPoints = 6000;

// The first gate, in gates of AlignOptions: what the chain may have drifted by.
constexpr double kFirstGates = 3.0;
constexpr double kKernelPerGate = 0.25;

// A registration of two single scans convinces with this share of points on surfaces. Fifteen voxels apart, right ones
// have 0.2 to 0.9.
constexpr double kMinShare = 0.15;

// A direct pose contradicts the chain if it is farther off than this many times what is expected, and this many times
// the points are on surfaces. In streets most points are on surfaces along which the sensor moves, so that the share is
// small.
constexpr double kExpectedTimes = 2.0;
constexpr double kMinGain = 1.05;

// Deviations that a drift is expected to stay below.
constexpr double kMaxDeviations = 3.0;

Cloud on_surfaces(const Cloud& scan) {
  Cloud kept;
  kept.origin = scan.origin;
  for (std::size_t i = 0; i < scan.size(); ++i) {
    if (scan.structures[i] == Structure::None) continue;
    kept.points.push_back(scan.points[i]);
    kept.directions.push_back(scan.directions[i]);
    kept.structures.push_back(scan.structures[i]);
  }
  return kept;
}

// The variance of the place of a typical point, square metres. offset: from the point about which the covariance
// rotates to the sensor.
double variance_of_a_point(const std::optional<Mat6d>& covariance, const Vec3d& offset, double typical_distance) {
  if (!covariance) return 0.0;
  const Mat6d here = covariance_about(*covariance, offset);
  return here.topLeftCorner<3, 3>().trace() +
         typical_distance * typical_distance * here.bottomRightCorner<3, 3>().trace();
}

AlignResult direct(const KnownClouds& clouds, const Rigid3& guess, AlignOptions options) {
  const AlignOptions last = options;
  options.gates.max_distance *= kFirstGates;
  options.min_kernel_chi2 = std::pow(kKernelPerGate * options.gates.max_distance, 2);
  options.correlation_length = 0.0;
  const AlignResult wide = align(clouds, without_origins(guess, clouds.source, clouds.matcher.target()), options);
  return align(clouds, wide.target_from_source, last);
}

DriftCheck compared(const KnownClouds& clouds, const Rigid3& chained, const Rigid3& found,
                    const SelfCheckOptions& options) {
  const Cloud &scan = clouds.source, &keyframe = clouds.matcher.target();
  const auto share_at = [&](const Rigid3& keyframe_from_scan) {
    const Rigid3 pose = without_origins(keyframe_from_scan, scan, keyframe);
    const auto pairs = clouds.session.match(pose, options.align_by.gates, options.align_by.num_threads);
    return surface_agreement({scan, keyframe, pairs, pose}, options.on_surface).share;
  };
  DriftCheck check;
  check.keyframe_from_sensor = found;
  check.distance_m = chained.translation.norm();
  check.drift_m = (chained.translation - found.translation).norm();
  check.drift_deg = angle_between(chained, found) * kDegPerRad;
  check.share_chained = share_at(chained), check.share_direct = share_at(found);
  return check;
}

}  // namespace

void SelfCheck::remember(double stamp_s, const Cloud& scan, const Rigid3& world_from_sensor,
                         const std::optional<Mat6d>& covariance, double min_distance) {
  if (!keyframes_.empty() &&
      (keyframes_.back()->world_from_sensor.translation - world_from_sensor.translation).norm() < min_distance)
    return;
  keyframes_.push_back(
      std::make_shared<const Keyframe>(Keyframe{stamp_s, world_from_sensor, covariance, on_surfaces(scan)}));
  if (keyframes_.size() > kMaxKeyframes) keyframes_.pop_front();
}

std::size_t SelfCheck::num_points() const {
  std::size_t count = 0;
  for (const auto& keyframe : keyframes_) count += keyframe->surfaces.size();
  return count;
}

// The last one that is far enough back, or the oldest.
const SelfCheck::Keyframe* SelfCheck::chosen(const Vec3d& place_in_world, double distance) const {
  for (auto keyframe = keyframes_.rbegin(); keyframe != keyframes_.rend(); ++keyframe)
    if (((*keyframe)->world_from_sensor.translation - place_in_world).norm() >= distance) return keyframe->get();
  return keyframes_.empty() ? nullptr : keyframes_.front().get();
}

std::optional<DriftCheck> SelfCheck::check(const Cloud& scan, const Rigid3& world_from_sensor,
                                           const std::optional<Mat6d>& covariance,
                                           const SelfCheckOptions& options) const {
  const Keyframe* const keyframe = chosen(world_from_sensor.translation, options.distance);
  if (!keyframe) return std::nullopt;
  const Cloud source = on_surfaces(evenly_chosen(scan, kMaxPoints));
  if (keyframe->surfaces.empty() || source.empty()) return std::nullopt;
  const NearestMatcher matcher(keyframe->surfaces);
  const Rigid3 chained = inverse(keyframe->world_from_sensor) * world_from_sensor;
  const std::unique_ptr<MatchSession> session = matcher.session(source);
  const KnownClouds clouds{source, matcher, *session};
  const AlignResult result = direct(clouds, chained, options.align_by);
  if (result.status != AlignStatus::Converged) return std::nullopt;
  const Rigid3 found = with_origins(result.target_from_source, source, matcher.target());
  DriftCheck check = compared(clouds, chained, found, options);
  check.keyframe_stamp_s = keyframe->stamp_s;
  const double typical = options.typical_distance;
  const Vec3d from_keyframe = world_from_sensor.translation - keyframe->world_from_sensor.translation;
  const double variance = variance_of_a_point(covariance, Vec3d::Zero(), typical) +
                          variance_of_a_point(keyframe->covariance, from_keyframe, typical) +
                          variance_of_a_point(result.covariance, result.target_from_source.translation, typical);
  check.expected_m = kMaxDeviations * std::sqrt(variance);
  const double drift = check.drift_m + typical * check.drift_deg * kRadPerDeg;
  check.contradicts = drift > options.on_surface + kExpectedTimes * check.expected_m &&
                      check.share_direct > kMinGain * check.share_chained;
  if (check.share_direct < kMinShare) return std::nullopt;
  return check;
}

}  // namespace augicp
