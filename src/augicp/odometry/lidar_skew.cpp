// SPDX-License-Identifier: MIT
// Whether LidarOdometry takes scans as skewed.
#include "augicp/odometry/lidar_attempt.h"

namespace augicp {
namespace {

// Scans tell whether they are skewed if the motion bends them by more than this, voxels.
constexpr double kTrialVoxels = 0.25;

}  // namespace

bool LidarOdometry::is_taken_as_skewed(const SweepShares& shares) const {
  return options_.deskew && !shares.empty() && skew_votes_.is_skewed();
}

bool LidarOdometry::is_bent(const SweepMotion& motion) const {
  return bending_between(motion, {}, typical_distance(voxel_size_)) > kTrialVoxels * voxel_size_;
}

// After a gap the motion during the sweep is unknown, and no scan is compared.
bool LidarOdometry::may_show_skew(double stamp_s, const SweepShares& shares) const {
  if (!options_.deskew || shares.empty() || skew_votes_.is_decided() || !skew_reference_) return false;
  return !before_last_ || spans_since_last(stamp_s) <= kTrustedSpans;
}

// A scan is compared with one before it, both as they came. REQUIRES: may_show_skew(), and the scan was registered.
LidarOdometry::SkewTrial LidarOdometry::tried_skew(const TimedScan& scan) {
  TimedScan& reference = *skew_reference_;
  if (last_->stamp_s == reference.pose.stamp_s) reference.motion = later_by(-1.0, scan.motion);  // it shows only now
  if (!is_bent(scan.motion) && !is_bent(reference.motion)) return {scan, false, false, std::nullopt};
  const auto skewed = [&](const TimedScan& timed) {
    return skewed_scan(timed.cloud, timed.shares, timed.motion, timed.pose.world_from_camera, voxel_size_);
  };
  return {scan, true, false, estimate_skew(skewed(reference), skewed(scan), voxel_size_, options_.num_threads)};
}

// As the votes say with this scan's own. Where the map has no bent scans, or only the first one, a change of mind is
// free: the scan is registered again, and its pose is not off by as much as a sweep is bent.
LidarOdometry::Attempt LidarOdometry::registered_as_it_shows(double stamp_s, const Cloud& scan,
                                                             const SweepShares& shares,
                                                             std::optional<SkewTrial>& trial) {
  const auto as_believed = [&] {
    return registered(stamp_s, scan, is_taken_as_skewed(shares) ? shares : SweepShares{});
  };
  const auto timed = [&](const Attempt& attempt) {
    const Rigid3& pose = attempt.world_from_sensor;
    return TimedScan{scan, shares, {stamp_s, pose}, motion_of_sweep(stamp_s, pose)};
  };
  Attempt attempt = as_believed();
  if (!may_show_skew(stamp_s, shares) || status_of(stamp_s, attempt) != FrameStatus::Tracked) return attempt;
  trial = tried_skew(timed(attempt));
  if (!trial->is_bent) return attempt;
  const bool was_skewed = skew_votes_.is_skewed(), is_free = start_scan_ || !has_bent_scans_;
  skew_votes_.add(trial->estimate, is_free);
  if (skew_votes_.is_skewed() == was_skewed) return attempt;
  if (!is_free) {
    trial->restarts_map = true;
    return attempt;
  }
  if (start_scan_) restart_map_with(*start_scan_, skew_votes_.is_skewed());
  attempt = as_believed();
  trial->scan = timed(attempt);
  return attempt;
}

// After a scan was followed. If the majority has changed, the map starts again with it: the map consists of scans that
// were bent, or left bent.
void LidarOdometry::conclude(const SkewTrial& trial) {
  if (trial.restarts_map) {
    start_scan_.reset();
    restart_map_with(trial.scan, skew_votes_.is_skewed());
    usual_agreement_ = 0.0;  // that with the map before
  }
  const Rigid3& before = skew_reference_->pose.world_from_camera;
  if (skew_votes_.is_decided())
    skew_reference_.reset();
  else if ((trial.scan.pose.world_from_camera.translation - before.translation).norm() > typical_distance(voxel_size_))
    skew_reference_ = trial.scan;
}

}  // namespace augicp
