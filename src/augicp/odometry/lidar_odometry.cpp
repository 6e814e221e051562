// SPDX-License-Identifier: MIT
#include "augicp/odometry/lidar_odometry.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "augicp/cloud/voxel_grid.h"
#include "augicp/core/check.h"
#include "augicp/odometry/lidar_attempt.h"
#include "augicp/odometry/seen_through.h"
#include "augicp/registration/far_outliers.h"
#include "augicp/registration/registration.h"
#include "augicp/shutter/rolling_shutter.h"
#include "augicp/trust/covariance.h"

namespace augicp {
namespace {

// Fewer points say nothing about six numbers in the noise of a scan.
constexpr std::size_t kMinPoints = 200;

// Voxels of a street of 50 m are then 0.7 m wide.
constexpr double kVoxelsPerExtent = 70.0;

// LiDARs err by one to three centimetres, so that a plane in a smaller voxel is as thick as wide; what fills a larger
// one is seldom a plane. Metres.
constexpr double kMinVoxel = 0.2;
constexpr double kMaxVoxel = 0.7;

// How fast the usual share of points on the map's surfaces follows the last scans'.
constexpr double kForgetting = 0.1;

// In the hand, where motion is uneven, the usual share sinks with the poses that go wrong: a scan with a smaller share
// of its points on the map's surfaces does not convince then, whatever is usual. Right scans of real sensors that are
// carried have 0.34 and more with the derived voxels; in small ones that are given, noise may be thicker than what
// counts as on a surface. Among vegetation 0.22 is usual.
constexpr double kLeastAgreement = 0.25;

// Keyframes that only rotated are not remembered for the self-check, voxels.
constexpr double kRememberedVoxels = 1.0;

// 0 where all points are in one place.
double derived_voxel(const Cloud& scan) {
  const double extent = robust_extent(scan_of(scan));
  return extent > 0.0 ? std::clamp(extent / kVoxelsPerExtent, kMinVoxel, kMaxVoxel) : 0.0;
}

}  // namespace

void LidarOptions::check() const {
  if (voxel_size) require_positive("voxel_size", *voxel_size);
  require_positive("keyframe_distance_voxels", keyframe_distance_voxels);
  require_positive("keyframe_angle", keyframe_angle);
  require_positive("reach_voxels", reach_voxels);
  require_positive("gate_voxels", gate_voxels);
  require_positive("on_surface_voxels", on_surface_voxels);
  require_not_negative("sweep_s", sweep_s);
  require_not_negative("min_observability", min_observability);
  require(min_agreement >= 0.0 && min_agreement <= 1.0, "min_agreement", min_agreement, "must be from 0 to 1");
  require(check_every >= 0, "check_every", check_every, "must be at least 0 (0: never)");
  require_positive("check_distance_voxels", check_distance_voxels);
  require(max_lost >= 1, "max_lost", max_lost, "must be at least 1");
  if (max_memory_gb) require(*max_memory_gb > 0.0, "max_memory_gb", *max_memory_gb, "must be above 0");
  require(num_threads >= 0, "num_threads", num_threads, "must be at least 0 (0: all)");
}

LidarOdometry::LidarOdometry(const LidarOptions& options) : options_(options) { options.check(); }

bool LidarOdometry::is_convincing(double stamp_s, const Attempt& attempt) const {
  const double least = options_.voxel_size || !is_uneven(stamp_s, attempt.world_from_sensor) ? 0.0 : kLeastAgreement;
  return attempt.agreement >= std::max(options_.min_agreement * usual_agreement_, least);
}

FrameStatus LidarOdometry::status_of(double stamp_s, const Attempt& attempt) const {
  const AlignStatus status = attempt.result.status;
  if (!has_pose(status) || attempt.agreement < 0.5 * options_.min_agreement * usual_agreement_)
    return FrameStatus::Lost;
  if (!is_convincing(stamp_s, attempt)) return FrameStatus::Doubtful;
  return status == AlignStatus::Degenerate ? FrameStatus::Degenerate : FrameStatus::Tracked;
}

// Of the increment about the sensor's place.
std::optional<Mat6d> LidarOdometry::covariance_at_sensor(const Attempt& attempt) const {
  if (!attempt.result.covariance) return std::nullopt;
  return covariance_about(*attempt.result.covariance,
                          attempt.world_from_sensor.translation - matcher_->target().origin);
}

void LidarOdometry::remove_seen_through(const Attempt& attempt) {
  if (!surfaces_) return;
  std::vector<Vec3d> places;
  for (const std::uint32_t i : seen_through(*surfaces_, attempt.fine, attempt.world_from_sensor, voxel_size_))
    places.push_back(surfaces_->origin + surfaces_->points[i].cast<double>());
  map_->forget_at(places);
}

SurfaceMap LidarOdometry::empty_map() const {
  SurfaceMapOptions map_options;
  map_options.voxel_size = voxel_size_;
  if (!options_.parts.has_edges) map_options.min_scans_of_edge = std::numeric_limits<int>::max();
  return SurfaceMap(map_options);
}

void LidarOdometry::merge(double stamp_s, const Attempt& attempt) {
  const Rigid3& pose = attempt.world_from_sensor;
  if (options_.remove_seen_through) remove_seen_through(attempt);
  if (options_.parts.is_last_scan_alone) map_ = empty_map();
  map_->add(attempt.fine, pose);
  has_bent_scans_ = has_bent_scans_ || (attempt.motion && is_bent(*attempt.motion));
  map_->forget_beyond(pose.translation, options_.reach_voxels * voxel_size_);
  if (options_.check_every > 0)
    self_check_.remember(stamp_s, attempt.source, pose, covariance_at_sensor(attempt), kRememberedVoxels * voxel_size_);
  surfaces_ = std::make_shared<Cloud>(map_->surfaces(pose.translation));
  matcher_ = std::make_shared<NearestMatcher>(*surfaces_);
  keyframe_ = Keyframe{attempt.fine, pose};
}

void LidarOdometry::start_segment(const Cloud& scan, const SweepShares& shares, FrameReport& report) {
  if (last_) {
    report.world_from_camera = last_->world_from_camera;
    ++segment_;
  }
  report.status = FrameStatus::Started;
  report.is_keyframe = true;
  report.segment = segment_;
  map_ = empty_map();
  has_bent_scans_ = false;
  Attempt attempt = prepared(scan, {}, SweepMotion{});
  attempt.world_from_sensor = report.world_from_camera;
  self_check_.clear();
  standstill_ = {};
  standstill_.add(report.world_from_camera, Mat6d::Zero());
  num_since_check_ = 0;
  merge(report.stamp_s, attempt);
  start_scan_.reset();
  if (options_.deskew && !shares.empty())
    start_scan_ = TimedScan{scan, shares, {report.stamp_s, report.world_from_camera}, {}};
  skew_reference_ = skew_votes_.is_decided() ? std::nullopt : start_scan_;
  usual_agreement_ = prediction_error_ = unevenness_ = 0.0;
  last_shown_.reset();
  before_last_.reset();
  beyond_arc_ = {};
  is_last_degenerate_ = false;
  last_ = StampedPose{report.stamp_s, report.world_from_camera};
}

LidarMemory LidarOdometry::memory_for(std::size_t num_points) const {
  const std::size_t num_added = num_points > 0 ? num_voxels_of_scan_ : 0;
  return {num_points, num_voxels() + num_added, self_check_.num_points()};
}

void LidarOdometry::require_memory_for(const Cloud& scan) {
  const auto near = [&] {
    Cloud cloud = scan;
    drop_far_outliers(cloud, kReachVoxels * voxel_size_);
    return cloud;
  };
  if (num_voxels_of_scan_ == 0) num_voxels_of_scan_ = count_voxels(near(), voxel_size_);
  const LidarMemory needed = memory_for(scan.size());
  const double max_gb = allowed_gb(options_.max_memory_gb);
  if (needed.gb() > max_gb) require_memory(needed, near(), voxel_size_, max_gb);
}

FrameReport LidarOdometry::placed(double stamp_s, const Cloud& scan, const SweepShares& shares) {
  FrameReport report;
  report.stamp_s = stamp_s;
  report.segment = segment_;
  if (voxel_size_ == 0.0 && scan.size() >= kMinPoints) voxel_size_ = options_.voxel_size.value_or(derived_voxel(scan));
  if (scan.size() < kMinPoints || !(voxel_size_ > 0.0)) {
    report.status = FrameStatus::NoReadings;
    report.problem = std::to_string(scan.size()) + " points, at least " + std::to_string(kMinPoints) +
                     " in more than one place are needed";
    return report;
  }
  require_memory_for(scan);
  if (!map_ || num_lost_ >= options_.max_lost) {
    num_lost_ = 0;
    start_segment(scan, shares, report);
    return report;
  }
  const Rigid3 guess = predicted(stamp_s);
  if (is_after_pause(stamp_s)) start_scan_.reset();
  if (!is_taken_as_skewed(shares)) start_scan_.reset();
  if (start_scan_) straighten_start(stamp_s, scan, shares);
  const bool is_third = before_last_.has_value();
  std::optional<SkewTrial> trial;
  Attempt attempt = registered_as_it_shows(stamp_s, scan, shares, trial);
  report.status = status_of(stamp_s, attempt);
  if (wants_covariance() || is_near_last(attempt))
    attempt.result.covariance = covariance_of(attempt.result, attempt.source);
  if (report.status == FrameStatus::Tracked) settle(attempt);
  if (report.status == FrameStatus::Tracked) report.drift = checked(attempt);
  describe(attempt, report);
  if (report.status != FrameStatus::Tracked) trial.reset();
  follow(attempt, guess, report);
  if (is_third) start_scan_.reset();
  if (trial) conclude(*trial);
  return report;
}

// What the registration found, whether or not it is used.
void LidarOdometry::describe(const Attempt& attempt, FrameReport& report) const {
  report.registration = attempt.result.status;
  report.iterations = attempt.iterations;
  report.num_pairs = attempt.result.num_pairs;
  report.overlap = attempt.agreement;
  report.rmse = attempt.rmse;
  if (options_.covariance) report.covariance = attempt.result.covariance;
  report.free_motions = attempt.result.free_motions;
  for (FreeMotion& motion : report.free_motions) motion.point += matcher_->target().origin;
  if (report.status == FrameStatus::Lost) return;
  report.world_from_camera = attempt.world_from_sensor;
  report.motion = attempt.motion;
  if (attempt.motion)
    report.world_from_camera = attempt.world_from_sensor * attempt.motion->middle_from(share_of(options_.pose_at));
}

// Takes a scan's pose for the place of the sensor, unless it is lost or doubtful. One that the self-check contradicts
// is doubtful, too, but where the map has it: the scans after it are followed from there.
void LidarOdometry::follow(const Attempt& attempt, const Rigid3& guess, FrameReport& report) {
  const bool is_astray = report.status == FrameStatus::Lost || report.status == FrameStatus::Doubtful;
  num_lost_ = is_astray ? num_lost_ + 1 : 0;
  if (report.status == FrameStatus::Lost) return;
  usual_agreement_ += (usual_agreement_ == 0.0 ? 1.0 : kForgetting) * (attempt.agreement - usual_agreement_);
  if (is_astray) return;
  num_since_check_ = is_check_due() ? 0 : num_since_check_ + 1;
  if (report.drift && report.drift->contradicts) {
    report.status = FrameStatus::Doubtful;
    report.problem = "a direct registration to a keyframe farther back contradicts";
  }
  const double error = motion_between(guess, attempt.world_from_sensor, typical_distance(voxel_size_));
  // A prediction across a pause that was right shows that the sensor goes on as it moved.
  const bool has_paused = is_after_pause(report.stamp_s) && error > options_.gate_voxels * voxel_size_;
  // The second scan of a segment is the first to show a velocity.
  const double unevenness = before_last_ ? unevenness_at(report.stamp_s, attempt.world_from_sensor) : 0.0;
  if (!has_paused) {
    prediction_error_ = std::max(error, (1.0 - kForgetting) * prediction_error_);
    unevenness_ = std::max(unevenness, (1.0 - kForgetting) * unevenness_);
  }
  beyond_arc_ = beyond_arc(report.stamp_s, attempt.world_from_sensor);
  last_shown_ = attempt.shows_motion ? attempt.motion : std::nullopt;
  is_last_degenerate_ = report.status == FrameStatus::Degenerate;
  before_last_ = has_paused ? std::nullopt : last_;
  last_ = StampedPose{report.stamp_s, attempt.world_from_sensor};
  const Rigid3 since = inverse(keyframe_->world_from_sensor) * attempt.world_from_sensor;
  const bool is_far = options_.parts.is_last_scan_alone ||
                      since.translation.norm() > options_.keyframe_distance_voxels * voxel_size_ ||
                      angle_between(since, Rigid3{}) > options_.keyframe_angle;
  report.is_keyframe = is_far && !has_paused && report.status != FrameStatus::Doubtful;
  if (report.is_keyframe) merge(report.stamp_s, attempt);
}

FrameReport LidarOdometry::add(double stamp_s, const Cloud& scan, const SweepShares& shares,
                               const std::stop_token& stop) {
  const std::stop_token own = options_.stop;
  if (stop.stop_possible()) options_.stop = stop;
  try {
    FrameReport report = added(stamp_s, scan, shares);
    options_.stop = own;
    return report;
  } catch (...) {
    options_.stop = own;
    throw;
  }
}

FrameReport LidarOdometry::added(double stamp_s, const Cloud& scan, const SweepShares& shares) {
  require(shares.empty() || shares.size() == scan.size(), "shares", static_cast<double>(shares.size()),
          "must be none, or one a point");
  if (!std::isfinite(stamp_s) || (last_stamp_s_ && stamp_s <= *last_stamp_s_))
    return frame_out_of_order(stamp_s, segment_, last_stamp_s_);
  const double before = shortest_gap_s_;
  if (last_stamp_s_) {
    const double gap_s = stamp_s - *last_stamp_s_;
    shortest_gap_s_ = before == 0.0 ? gap_s : std::min(before, gap_s);
  }
  try {
    FrameReport report = placed(stamp_s, scan, shares);
    last_stamp_s_ = stamp_s;
    return report;
  } catch (...) {
    shortest_gap_s_ = before;
    if (!map_) voxel_size_ = 0.0, num_voxels_of_scan_ = 0;
    throw;
  }
}

Cloud LidarOdometry::map() const { return map_ ? map_->surfaces(Vec3d::Zero()) : Cloud{}; }

}  // namespace augicp
