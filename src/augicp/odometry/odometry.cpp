// SPDX-License-Identifier: MIT
#include "augicp/odometry/odometry.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "augicp/core/check.h"
#include "augicp/core/stop.h"
#include "augicp/odometry/depth_memory.h"
#include "augicp/shutter/rolling_shutter.h"

namespace augicp {
namespace {

// Fewer say nothing about six numbers in the noise of an image.
constexpr std::size_t kMinReadings = 500;

// A camera that is followed is where it is expected to within a few centimetres, so that the gates of a first guess
// only let wrong pairs in: a quarter of the distance, and half of the angle.
constexpr double kGatePerFirstGate = 0.25;
constexpr double kMaxAngle = 0.5;

// Frames of a moving camera are smeared less than two images far apart differ, and a smaller ball keeps more of the
// scene's shape: on fr1 it takes a sixth off the drift. Half of it would lose the far walls of fr1/rpy.
constexpr double kRadiusPerFirstRadius = 0.7;

// Steps below this part of the extent, some tenths of a millimetre, are far below what a frame's noise does to its
// pose.
constexpr double kMinStep = 1e-4;
constexpr int kMaxIterations = 30;

// Columns of an image that are used unless told otherwise. On fr1, twice as many cost four times the work and drift as
// much: what limits it there is not the noise of single pixels.
constexpr int kUsualColumns = 160;

// Two frames nearer in time than this are one moment, seconds: no camera is that fast, and a speed from them is noise.
constexpr double kMinPassed_s = 0.004;

// How the motion during a readout is found out: guessed from the last one, then taken from the registration.
constexpr int kPasses = 2;

Lengths tracking_lengths(const Scan& frame, const Scan& reference, const RegistrationOptions& options) {
  Lengths lengths = lengths_for(frame, reference, options);
  if (!options.radius) lengths.radius *= kRadiusPerFirstRadius;
  if (!options.max_distance) lengths.max_distance *= kGatePerFirstGate;
  return lengths;
}

FrameStatus frame_status(AlignStatus status, double strain, const OdometryOptions& options) {
  switch (status) {
    case AlignStatus::Converged:
    case AlignStatus::IterationLimit:
    case AlignStatus::Doubtful:
    case AlignStatus::Ambiguous:
      return strain > options.max_strain ? FrameStatus::Doubtful : FrameStatus::Tracked;
    case AlignStatus::Degenerate:
      return FrameStatus::Degenerate;
    default:
      return FrameStatus::Lost;
  }
}

MergeOptions merge_options(const Lengths& lengths) {
  MergeOptions options;
  options.max_distance = lengths.radius;
  return options;
}

}  // namespace

RegistrationOptions tracking_options() {
  // The guess is good, and odometry knows the motion during a readout from the motion between frames.
  RegistrationOptions options = iterations_alone();
  options.max_angle = kMaxAngle;
  options.min_step = kMinStep;
  options.max_iterations = kMaxIterations;
  options.covariance = false;  // no report has it
  return options;
}

void OdometryOptions::check() const {
  registration.check();
  require(pixel_step >= 0, "pixel_step", pixel_step, "must be at least 0 (0: as leaves 160 columns)");
  require(range.min >= 0.0, "range.min", range.min, "must be at least 0");
  require(range.max > range.min, "range.max", range.max, "must be above range.min, which is at least 0");
  require(min_overlap >= 0.0 && min_overlap <= 1.0, "min_overlap", min_overlap, "must be from 0 to 1");
  require(keyframe_overlap >= 0.0 && keyframe_overlap <= 1.0, "keyframe_overlap", keyframe_overlap,
          "must be from 0 to 1");
  require(max_strain > 0.0, "max_strain", max_strain, "must be above 0");
  require(max_lost >= 1, "max_lost", max_lost, "must be at least 1");
  require_not_negative("max_extrapolation_s", max_extrapolation_s);
}

Scan prepare_frame(const DepthImage& image, const DepthCamera& camera, const OdometryOptions& options) {
  const int step = options.pixel_step > 0 ? options.pixel_step : std::max(1, image.width / kUsualColumns);
  const Pinhole& pinhole = camera.pinhole;
  const bool has_its_size = pinhole.width == 0 || (pinhole.width == image.width && pinhole.height == image.height);
  if (has_its_size) require_memory(image.width, image.height, step, options);  // else scan_of() refuses it
  Scan scan = scan_of(image, camera, step, options.range);
  const Lengths lengths = tracking_lengths(scan, scan, options.registration);
  return prepare(std::move(scan), lengths, options.registration);
}

Odometry::Odometry(const OdometryOptions& options, double readout_s) : options_(options), readout_s_(readout_s) {
  options.check();
  require_not_negative("readout_s", readout_s);
}

// Constant velocity, in the camera's frame.
Rigid3 Odometry::predicted(double stamp_s) const {
  const double ahead_s = stamp_s - last_->stamp_s;
  const bool has_speed = before_last_ && last_->stamp_s - before_last_->stamp_s >= kMinPassed_s;
  if (!has_speed || ahead_s > options_.max_extrapolation_s) return last_->world_from_camera;
  const Rigid3 motion = inverse(before_last_->world_from_camera) * last_->world_from_camera;
  return last_->world_from_camera * part_of(motion, ahead_s / (last_->stamp_s - before_last_->stamp_s));
}

// The frame without the skew of a camera that has come from the last pose to this one.
Scan Odometry::straightened(const Scan& frame, double stamp_s, const Rigid3& world_from_camera) const {
  const double passed_s = stamp_s - last_->stamp_s;
  // Two frames read out at the same time for the most part: the stamps are wrong.
  const bool is_too_short = passed_s < kMinPassed_s || passed_s < 0.5 * readout_s_;
  if (readout_s_ == 0.0 || is_too_short || passed_s > options_.max_extrapolation_s) return frame;
  const Rigid3 motion = inverse(last_->world_from_camera) * world_from_camera;
  return without_skew(frame, part_of(motion, readout_s_ / passed_s), options_.registration.num_threads);
}

// Fills in the report; gives the frame as it was registered.
Scan Odometry::register_frame(const Scan& frame, const RegistrationOptions& options, FrameReport& report) {
  const Lengths lengths = tracking_lengths(frame, reference_->scan, options);
  report.world_from_camera = predicted(report.stamp_s);
  Scan straight;
  std::optional<LocalModel> straight_start;
  for (int pass = 0; pass < (readout_s_ > 0.0 ? kPasses : 1); ++pass) {
    straight = straightened(frame, report.stamp_s, report.world_from_camera);
    // The first frame of a segment was taken as it came: only now is it known how the camera moved then.
    if (start_frame_ && pass > 0)
      straight_start = model_of(straightened(*start_frame_, report.stamp_s, report.world_from_camera));
    const AlignResult result =
        register_prepared({straight, (straight_start ? straight_start : reference_)->scan, lengths},
                          inverse(world_from_reference_) * report.world_from_camera, options);
    report.registration = result.status;
    report.iterations += result.iterations;
    report.num_pairs = result.num_pairs;
    report.overlap = result.overlap;
    report.rmse = result.rmse;
    report.strain = result.evidence ? strain(*result.evidence) : 0.0;
    report.status = frame_status(result.status, report.strain, options_);
    if (report.overlap < options_.min_overlap) report.status = FrameStatus::Lost;
    if (report.status == FrameStatus::Lost) break;
    report.world_from_camera = world_from_reference_ * result.target_from_source;
  }
  if (report.status == FrameStatus::Tracked && start_frame_) {
    if (straight_start) reference_ = std::move(straight_start);
    start_frame_.reset();
  }
  return straight;
}

void Odometry::update_reference(const Scan& frame, const FrameReport& report) {
  const Rigid3 reference_from_frame = inverse(world_from_reference_) * report.world_from_camera;
  const int num_threads = options_.registration.num_threads;
  const MergeOptions merge_by = merge_options(tracking_lengths(frame, reference_->scan, options_.registration));
  if (options_.reference == Reference::PreviousFrame) {
    reference_ = model_of(frame);
  } else if (report.is_keyframe) {
    reference_ = carried_over(*reference_, frame, inverse(reference_from_frame), merge_by, num_threads);
  } else {
    merge(*reference_, frame, reference_from_frame, merge_by, num_threads);
    return;
  }
  world_from_reference_ = report.world_from_camera;
}

void Odometry::start_segment(const Scan& frame, FrameReport& report) {
  if (last_) {
    report.world_from_camera = last_->world_from_camera;
    ++segment_;
  }
  report.status = FrameStatus::Started;
  report.is_keyframe = true;
  reference_ = model_of(frame);
  if (readout_s_ > 0.0) start_frame_ = frame;
  world_from_reference_ = report.world_from_camera;
  before_last_.reset();
  last_ = StampedPose{report.stamp_s, report.world_from_camera};
}

FrameReport Odometry::add(double stamp_s, const Scan& frame, const std::stop_token& stop) {
  if (!std::isfinite(stamp_s) || (last_stamp_s_ && stamp_s <= *last_stamp_s_))
    return frame_out_of_order(stamp_s, segment_, last_stamp_s_);
  const FrameReport report = placed(stamp_s, frame, stop);
  last_stamp_s_ = stamp_s;
  return report;
}

// Where it is interrupted it has changed nothing.
FrameReport Odometry::placed(double stamp_s, const Scan& frame, const std::stop_token& stop) {
  RegistrationOptions options = options_.registration;
  if (stop.stop_possible()) options.stop = stop;
  throw_if_stopped(options.stop);
  FrameReport report;
  report.stamp_s = stamp_s;
  report.segment = segment_;
  if (!frame.view || !frame.cloud.has_directions() || frame.cloud.size() < kMinReadings) {
    report.status = FrameStatus::NoReadings;
    report.problem =
        std::to_string(frame.cloud.size()) + " readings, at least " + std::to_string(kMinReadings) + " are needed";
    return report;
  }
  if (!reference_ || num_lost_ >= options_.max_lost) {
    num_lost_ = 0;
    start_segment(frame, report);
    report.segment = segment_;
    return report;
  }
  const Scan straight = register_frame(frame, options, report);
  const bool is_astray = report.status == FrameStatus::Lost || report.status == FrameStatus::Doubtful;
  num_lost_ = is_astray ? num_lost_ + 1 : 0;
  if (report.status == FrameStatus::Lost) return report;
  report.is_keyframe = report.status == FrameStatus::Tracked && report.overlap < options_.keyframe_overlap;
  if (report.status == FrameStatus::Tracked) update_reference(straight, report);
  before_last_ = last_;
  last_ = StampedPose{stamp_s, report.world_from_camera};
  return report;
}

}  // namespace augicp
