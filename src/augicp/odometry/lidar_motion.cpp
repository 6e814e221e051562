// SPDX-License-Identifier: MIT
// How the sensor of LidarOdometry moves: between scans, during a sweep, and during the first one.
#include <algorithm>

#include "augicp/odometry/lidar_attempt.h"
#include "augicp/shutter/rolling_shutter.h"

namespace augicp {
namespace {

// The first scan is straightened again while the second one's pose moves its points by more than this, and where the
// third one's pose does. The map then begins with the first scan anew. Voxels.
constexpr double kRedoBySecondVoxels = 0.02;
constexpr double kRedoByThirdVoxels = 0.25;
constexpr int kMaxStartRounds = 4;

// Of the last sweep in the average of accelerations.
constexpr double kShareOfLast = 0.5;

// Motion is uneven where constant rates are off by more than this, voxels.
constexpr double kUnevenVoxels = 0.25;

// An acceleration found in one sweep says nothing of later than this.
constexpr double kTrustedSweeps = 1.5;

}  // namespace

// The time since the last pose, in times that the last motion took. REQUIRES: before_last_.
double LidarOdometry::spans_since_last(double stamp_s) const {
  return (stamp_s - last_->stamp_s) / (last_->stamp_s - before_last_->stamp_s);
}

// The recording has paused for so long that the last motion says nothing.
bool LidarOdometry::is_after_pause(double stamp_s) const {
  return before_last_ && spans_since_last(stamp_s) > kForgottenSpans;
}

// By the motion that the last scan's own points showed, or by constant velocity.
Rigid3 LidarOdometry::predicted(double stamp_s) const {
  if (!last_shown_) return predicted_evenly(stamp_s);
  const double passed_s = stamp_s - last_->stamp_s, sweeps = passed_s / sweep_s(passed_s);
  if (sweeps > kTrustedSweeps) return predicted_evenly(stamp_s);
  return last_->world_from_camera * last_shown_->middle_from(0.5 + sweeps);
}

// Constant velocity, in the sensor's frame.
Rigid3 LidarOdometry::predicted_evenly(double stamp_s) const {
  if (!before_last_) return last_->world_from_camera;
  const Rigid3 motion = inverse(before_last_->world_from_camera) * last_->world_from_camera;
  return last_->world_from_camera * part_of(motion, spans_since_last(stamp_s));
}

// How far constant rates are off at this pose, on an arc or along a line, metres at the distance of a typical point.
double LidarOdometry::unevenness_at(double stamp_s, const Rigid3& world_from_sensor) const {
  const Rigid3 on_an_arc = predicted_evenly(stamp_s);
  Rigid3 along_a_line = on_an_arc;
  if (before_last_) {
    const Vec3d &from = before_last_->world_from_camera.translation, &to = last_->world_from_camera.translation;
    along_a_line.translation = to + spans_since_last(stamp_s) * (to - from);
  }
  const double typical = typical_distance(voxel_size_);
  return std::min(motion_between(on_an_arc, world_from_sensor, typical),
                  motion_between(along_a_line, world_from_sensor, typical));
}

// Here or shortly before.
bool LidarOdometry::is_uneven(double stamp_s, const Rigid3& world_from_sensor) const {
  return std::max(unevenness_, unevenness_at(stamp_s, world_from_sensor)) > kUnevenVoxels * voxel_size_;
}

// Of a sweep this long after the last pose.
double LidarOdometry::sweep_s(double passed_s) const {
  if (options_.sweep_s > 0.0) return options_.sweep_s;
  return shortest_gap_s_ > 0.0 ? std::min(passed_s, shortest_gap_s_) : passed_s;
}

// By how much the motion of the sweep at this pose differs from an arc, as averaged over the last ones. Second
// differences of poses are noisy, and a scan straightened with too much of them gets a pose that is as wrong on the
// other side. Where motions are free, poses are partly predictions, and show no acceleration.
LidarOdometry::Accelerations LidarOdometry::beyond_arc(double stamp_s, const Rigid3& world_from_sensor) const {
  if (!before_last_ || is_last_degenerate_ || is_after_pause(stamp_s)) return {};
  const StampedPose now{stamp_s, world_from_sensor};
  const double duration_s = sweep_s(stamp_s - last_->stamp_s);
  const SweepMotion arc = motion_of_last(std::nullopt, *last_, now, duration_s);
  const SweepMotion found = motion_of_last(before_last_, *last_, now, duration_s);
  return {beyond_arc_.linear + kShareOfLast * (found.acceleration - arc.acceleration - beyond_arc_.linear),
          beyond_arc_.angular + kShareOfLast * (found.angular_acceleration - beyond_arc_.angular)};
}

// Of the sweep at this pose.
SweepMotion LidarOdometry::motion_of_sweep(double stamp_s, const Rigid3& world_from_sensor) const {
  const double passed_s = stamp_s - last_->stamp_s, duration_s = sweep_s(passed_s);
  SweepMotion motion = motion_of_last(std::nullopt, *last_, {stamp_s, world_from_sensor}, duration_s);
  const Accelerations more = beyond_arc(stamp_s, world_from_sensor);
  const double since_mean = 0.5 * passed_s / duration_s;  // sweeps
  motion.velocity += since_mean * more.linear;
  motion.acceleration += more.linear;
  motion.rotation += since_mean * more.angular;
  motion.angular_acceleration += more.angular;
  return motion;
}

// Of the first sweep, from the same poses.
SweepMotion LidarOdometry::motion_of_start(double stamp_s, const Rigid3& world_from_sensor) const {
  const double sweeps = (stamp_s - start_scan_->pose.stamp_s) / sweep_s(stamp_s - last_->stamp_s);
  return later_by(-sweeps, motion_of_sweep(stamp_s, world_from_sensor));
}

// The map starts again with this scan, where it was placed.
void LidarOdometry::restart_map_with(const TimedScan& scan, bool is_skewed) {
  Attempt attempt = prepared(scan.cloud, is_skewed ? scan.shares : SweepShares{}, scan.motion);
  attempt.world_from_sensor = scan.pose.world_from_camera;
  map_ = empty_map();
  has_bent_scans_ = false;
  self_check_.clear();
  merge(scan.pose.stamp_s, attempt);
}

// The first scan of a segment was taken as it came: only the second one shows how the sensor moved then, and the third
// whether it followed an arc. Both scans show the same motion, so that it is found again with what the last one gave.
void LidarOdometry::straighten_start(double stamp_s, const Cloud& scan, const SweepShares& shares) {
  const bool is_third = before_last_.has_value();
  const double least = (is_third ? kRedoByThirdVoxels : kRedoBySecondVoxels) * voxel_size_;
  for (int round = 0; start_scan_ && round < kMaxStartRounds && !is_last_degenerate_; ++round) {
    const Attempt attempt = registered(stamp_s, scan, shares);
    if (status_of(stamp_s, attempt) == FrameStatus::Lost) break;
    const SweepMotion found = motion_of_start(stamp_s, attempt.world_from_sensor);
    if (bending_between(found, start_scan_->motion, typical_distance(voxel_size_)) < least) break;
    start_scan_->motion = found;
    restart_map_with(*start_scan_, true);
  }
}

}  // namespace augicp
