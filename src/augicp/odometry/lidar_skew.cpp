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

// A scan that is tracked is compared with one before it, both as they came. After a gap the motion during the sweep is
// unknown, and no scan is compared. If the majority changes, the map starts again with this scan: it consists of scans
// that were bent, or left bent. REQUIRES: the scan was followed.
void LidarOdometry::try_skew(const TimedScan& scan) {
  if (skew_votes_.is_decided() || !skew_reference_) return;
  const double typical = typical_distance(voxel_size_);
  if (before_last_->stamp_s == skew_reference_->pose.stamp_s)  // its motion shows only now
    skew_reference_->motion = later_by(-1.0, scan.motion);
  const auto is_bent = [&](const SweepMotion& motion) {
    return bending_between(motion, {}, typical) > kTrialVoxels * voxel_size_;
  };
  const Rigid3& before = skew_reference_->pose.world_from_camera;
  const bool was_skewed = skew_votes_.is_skewed();
  if (is_bent(scan.motion) || is_bent(skew_reference_->motion)) {
    const auto skewed = [&](const TimedScan& timed) {
      return skewed_scan(timed.cloud, timed.shares, timed.motion, timed.pose.world_from_camera, voxel_size_);
    };
    skew_votes_.add(estimate_skew(skewed(*skew_reference_), skewed(scan), voxel_size_, options_.num_threads));
  }
  if (skew_votes_.is_skewed() != was_skewed) {
    start_scan_.reset();
    restart_map_with(scan, !was_skewed);
    usual_agreement_ = 0.0;  // that with the map before
  }
  if (skew_votes_.is_decided())
    skew_reference_.reset();
  else if ((scan.pose.world_from_camera.translation - before.translation).norm() > typical)
    skew_reference_ = scan;
}

}  // namespace augicp
