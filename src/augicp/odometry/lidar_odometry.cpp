// SPDX-License-Identifier: MIT
#include "augicp/odometry/lidar_odometry.h"

#include <algorithm>
#include <cmath>

#include "augicp/cloud/voxel_grid.h"
#include "augicp/core/check.h"
#include "augicp/registration/registration.h"
#include "augicp/shutter/rolling_shutter.h"

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

// Points of one scan enter the map once in a cell of this part of a voxel, so that a near surface does not outweigh the
// others; those that are registered are once in a cell of half a voxel.
constexpr double kCellsPerVoxel = 4.0;
constexpr double kSourceCellsPerVoxel = 2.0;

// Before any motion is known, the gate is this wide, voxels: a car moves by some metres between two scans.
constexpr double kFirstGate = 4.0;
constexpr double kMaxGate = 8.0;
constexpr double kGatePerError = 3.0;

// A gate wider than this many of the least ones is closed in two steps.
constexpr double kWideGate = 1.25;

// The kernel's least width, voxels: at the first step the right pairs are as far apart as the prediction is wrong.
constexpr double kMinKernel = 0.05;
constexpr double kKernelPerGate = 0.25;

// Pairs count fully up to about this many median residuals: parts of a sweep that the motion bends, and moving things,
// are a large minority of coherent pairs.
constexpr double kKernelPerMedian = 3.0;

constexpr int kMaxIterations = 40;
constexpr double kMinStepVoxels = 5e-4;
constexpr double kMinRotationStep = 5e-5;

// A sweep is straightened again where the motion found moves its points by more than this, voxels.
constexpr double kRedoVoxels = 0.01;

// Whether sweeps are skewed is found out on this many scans whose motion bends them by more than this, voxels. Clouds
// that were straightened by another program, or come at another rate than that of the sweep, are not.
constexpr int kNumTrials = 8;
constexpr double kTrialVoxels = 0.25;

// Two points share the voxel from which their directions come up to this far apart, voxels.
constexpr double kCorrelationVoxels = 2.0;

// How fast the usual share of points on the map's surfaces follows the last scans'.
constexpr double kForgetting = 0.1;

// The distance of a typical point, voxels: a rotation counts as what it moves a point there.
constexpr double kTypicalDistanceVoxels = 15.0;

// 0 where all points are in one place.
double derived_voxel(const Cloud& scan) {
  const double extent = robust_extent(scan_of(scan));
  return extent > 0.0 ? std::clamp(extent / kVoxelsPerExtent, kMinVoxel, kMaxVoxel) : 0.0;
}

double moved(const Rigid3& a, const Rigid3& b, double typical_distance) {
  return (a.translation - b.translation).norm() + typical_distance * angle_between(a, b);
}

double agreement_of(const Cloud& source, const Matcher& matcher, const Rigid3& world_from_source, const Gates& gates,
                    double on_surface, int num_threads, double& rmse) {
  const Cloud& target = matcher.target();
  const Rigid3 pose = without_origins(world_from_source, source, target);
  std::size_t num_on = 0;
  double sum_sq = 0.0;
  for (const Correspondence& pair : matcher.match(source, pose, gates, num_threads)) {
    const Vec3d moved_point = pose * source.points[pair.source].cast<double>();
    const Vec3d apart = moved_point - target.points[pair.target].cast<double>();
    const Vec3d direction = target.directions[pair.target].cast<double>();
    const double along = direction.dot(apart);
    const bool is_edge = target.structures[pair.target] == Structure::Edge;
    const double off = is_edge ? (apart - along * direction).norm() : std::abs(along);
    if (off > on_surface) continue;
    ++num_on;
    sum_sq += off * off;
  }
  rmse = num_on == 0 ? 0.0 : std::sqrt(sum_sq / static_cast<double>(num_on));
  return static_cast<double>(num_on) / static_cast<double>(source.size());
}

}  // namespace

struct LidarOdometry::Attempt {
  Cloud fine, source;
  AlignResult result;
  Rigid3 world_from_sensor;
  double agreement = 0.0, rmse = 0.0;
  int iterations = 0;
  std::optional<double> gain_of_deskewing;  // of the agreement, where both were tried
};

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
  require(max_lost >= 1, "max_lost", max_lost, "must be at least 1");
  require(num_threads >= 0, "num_threads", num_threads, "must be at least 0 (0: all)");
}

LidarOdometry::LidarOdometry(const LidarOptions& options) : options_(options) { options.check(); }

// Constant velocity, in the sensor's frame.
Rigid3 LidarOdometry::predicted(double stamp_s) const {
  if (!before_last_) return last_->world_from_camera;
  const Rigid3 motion = inverse(before_last_->world_from_camera) * last_->world_from_camera;
  const double share = (stamp_s - last_->stamp_s) / (last_->stamp_s - before_last_->stamp_s);
  return last_->world_from_camera * part_of(motion, share);
}

// From the last pose to this one; of a sweep that takes only a part of the time between them, that part.
Rigid3 LidarOdometry::motion_of_sweep(double stamp_s, const Rigid3& world_from_sensor) const {
  const double passed_s = stamp_s - last_->stamp_s;
  double sweep_s = options_.sweep_s > 0.0 ? options_.sweep_s : passed_s;
  if (options_.sweep_s == 0.0 && shortest_gap_s_ > 0.0) sweep_s = std::min(passed_s, shortest_gap_s_);
  return part_of(inverse(last_->world_from_camera) * world_from_sensor, sweep_s / passed_s);
}

LidarOdometry::Attempt LidarOdometry::prepared(const Cloud& scan, const SweepShares& shares,
                                               const Rigid3& first_from_last) const {
  Attempt attempt;
  const bool is_skewed = !shares.empty();
  const Cloud straight = is_skewed ? without_skew(scan, shares, first_from_last, options_.num_threads) : Cloud{};
  const Cloud& cloud = is_skewed ? straight : scan;
  attempt.fine = downsample(cloud, std::max(voxel_size_ / kCellsPerVoxel, bounds(cloud).diagonal() / (1 << 20)));
  attempt.fine.directions.clear(), attempt.fine.structures.clear();
  attempt.source = downsample(attempt.fine, voxel_size_ / kSourceCellsPerVoxel);
  SurfaceMapOptions of_one_scan;
  of_one_scan.voxel_size = voxel_size_;
  SurfaceMap own(of_one_scan);
  own.add(attempt.fine, Rigid3{});
  own.describe(attempt.source, Rigid3{});
  return attempt;
}

void LidarOdometry::align_to_map(const Rigid3& guess, double gate, Attempt& attempt) const {
  AlignOptions align_by;
  align_by.information = plane_information();
  align_by.kernel_per_median = kKernelPerMedian;
  align_by.max_iterations = kMaxIterations;
  align_by.min_translation_step = kMinStepVoxels * voxel_size_;
  align_by.min_rotation_step = kMinRotationStep;
  align_by.num_threads = options_.num_threads;
  align_by.stop = options_.stop;
  const double least = options_.gate_voxels * voxel_size_;
  attempt.world_from_sensor = guess;
  attempt.iterations = 0;
  for (bool is_last = false; !is_last; gate = least) {
    is_last = gate <= kWideGate * least;
    if (is_last) gate = least;
    align_by.gates.max_distance = gate;
    const double kernel = is_last ? kMinKernel * voxel_size_ : kKernelPerGate * gate;
    align_by.min_kernel_chi2 = kernel * kernel;
    align_by.min_observability = is_last ? options_.min_observability : 0.0;
    align_by.correlation_length = is_last && options_.covariance ? kCorrelationVoxels * voxel_size_ : 0.0;
    const Cloud& target = matcher_->target();
    attempt.result =
        align(attempt.source, *matcher_, without_origins(attempt.world_from_sensor, attempt.source, target), align_by);
    attempt.world_from_sensor = with_origins(attempt.result.target_from_source, attempt.source, target);
    attempt.iterations += attempt.result.iterations;
  }
  attempt.agreement = agreement_of(attempt.source, *matcher_, attempt.world_from_sensor, align_by.gates,
                                   options_.on_surface_voxels * voxel_size_, options_.num_threads, attempt.rmse);
}

// Registers to the last keyframe from many starts, and to the map from there.
void LidarOdometry::search(Attempt& attempt) const {
  RegistrationOptions registration;
  registration.num_threads = options_.num_threads;
  registration.stop = options_.stop;
  registration.covariance = false;
  const Rigid3 guess = inverse(keyframe_->world_from_sensor) * last_->world_from_camera;
  const AlignResult found =
      register_scans(scan_of(attempt.fine), scan_of(keyframe_->cloud), guess, registration).result;
  if (!has_pose(found.status)) return;
  Attempt other = attempt;
  align_to_map(keyframe_->world_from_sensor * found.target_from_source, 2.0 * options_.gate_voxels * voxel_size_,
               other);
  if (other.agreement > attempt.agreement) attempt = std::move(other);
}

LidarOdometry::Attempt LidarOdometry::registered(double stamp_s, const Cloud& scan, const SweepShares& shares) const {
  const double typical = kTypicalDistanceVoxels * voxel_size_;
  const Rigid3 guess = predicted(stamp_s);
  const Rigid3 motion = motion_of_sweep(stamp_s, guess);
  Attempt attempt = prepared(scan, shares, motion);
  const double gate =
      before_last_ ? options_.gate_voxels * voxel_size_ + kGatePerError * prediction_error_ : kFirstGate * voxel_size_;
  align_to_map(guess, std::min(gate, kMaxGate * voxel_size_), attempt);
  if (options_.search && attempt.agreement < options_.min_agreement * usual_agreement_) search(attempt);
  const Rigid3 found = motion_of_sweep(stamp_s, attempt.world_from_sensor);
  if (shares.empty() || moved(motion, found, typical) < kRedoVoxels * voxel_size_) return attempt;
  Attempt again = prepared(scan, shares, found);
  align_to_map(attempt.world_from_sensor, options_.gate_voxels * voxel_size_, again);
  again.iterations += attempt.iterations;
  return again;
}

// The scan straightened or as it came: as the trials of earlier scans have decided, or both and the better one.
LidarOdometry::Attempt LidarOdometry::tried(double stamp_s, const Cloud& scan, const SweepShares& shares) const {
  const bool is_decided = num_trials_ >= kNumTrials;
  const bool is_skewed = options_.deskew && !shares.empty() && (!is_decided || gain_of_deskewing_ > 0.0);
  Attempt attempt = registered(stamp_s, scan, is_skewed ? shares : SweepShares{});
  const double bent =
      moved(motion_of_sweep(stamp_s, attempt.world_from_sensor), Rigid3{}, kTypicalDistanceVoxels * voxel_size_);
  if (!is_skewed || is_decided || bent < kTrialVoxels * voxel_size_) return attempt;
  Attempt as_it_came = prepared(scan, {}, Rigid3{});
  align_to_map(attempt.world_from_sensor, options_.gate_voxels * voxel_size_, as_it_came);
  const double gain = attempt.agreement - as_it_came.agreement;
  if (gain_of_deskewing_ + gain < 0.0) std::swap(attempt, as_it_came);
  attempt.gain_of_deskewing = gain;
  return attempt;
}

FrameStatus LidarOdometry::status_of(const Attempt& attempt) const {
  const AlignStatus status = attempt.result.status;
  if (!has_pose(status) || attempt.agreement < 0.5 * options_.min_agreement * usual_agreement_)
    return FrameStatus::Lost;
  if (attempt.agreement < options_.min_agreement * usual_agreement_) return FrameStatus::Doubtful;
  return status == AlignStatus::Degenerate ? FrameStatus::Degenerate : FrameStatus::Tracked;
}

void LidarOdometry::merge(const Attempt& attempt) {
  const Rigid3& pose = attempt.world_from_sensor;
  map_->add(attempt.fine, pose);
  map_->forget_beyond(pose.translation, options_.reach_voxels * voxel_size_);
  surfaces_ = std::make_shared<Cloud>(map_->surfaces(pose.translation));
  matcher_ = std::make_shared<NearestMatcher>(*surfaces_);
  keyframe_ = Keyframe{attempt.fine, pose};
}

// The first scan of a segment was taken as it came: only with the second it is known how the sensor moved then.
void LidarOdometry::straighten_start(const Rigid3& first_from_last) {
  Attempt attempt = prepared(start_scan_->cloud, start_scan_->shares, first_from_last);
  attempt.world_from_sensor = keyframe_->world_from_sensor;
  start_scan_.reset();
  SurfaceMapOptions map_options;
  map_options.voxel_size = voxel_size_;
  map_.emplace(map_options);
  merge(attempt);
}

void LidarOdometry::start_segment(const Cloud& scan, const SweepShares& shares, FrameReport& report) {
  if (last_) {
    report.world_from_camera = last_->world_from_camera;
    ++segment_;
  }
  report.status = FrameStatus::Started;
  report.is_keyframe = true;
  report.segment = segment_;
  SurfaceMapOptions map_options;
  map_options.voxel_size = voxel_size_;
  map_.emplace(map_options);
  Attempt attempt = prepared(scan, {}, Rigid3{});
  attempt.world_from_sensor = report.world_from_camera;
  merge(attempt);
  start_scan_.reset();
  if (options_.deskew && !shares.empty()) start_scan_ = StartScan{scan, shares};
  usual_agreement_ = prediction_error_ = 0.0;
  before_last_.reset();
  last_ = StampedPose{report.stamp_s, report.world_from_camera};
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
  if (!map_ || num_lost_ >= options_.max_lost) {
    num_lost_ = 0;
    start_segment(scan, shares, report);
    return report;
  }
  const Rigid3 guess = predicted(stamp_s);
  if (start_scan_) {
    const Attempt first = registered(stamp_s, scan, shares);
    if (status_of(first) == FrameStatus::Lost) start_scan_.reset();
    if (start_scan_) straighten_start(motion_of_sweep(stamp_s, first.world_from_sensor));
  }
  const Attempt attempt = tried(stamp_s, scan, shares);
  report.registration = attempt.result.status;
  report.iterations = attempt.iterations;
  report.num_pairs = attempt.result.num_pairs;
  report.overlap = attempt.agreement;
  report.rmse = attempt.rmse;
  report.covariance = attempt.result.covariance;
  report.free_motions = attempt.result.free_motions;
  for (FreeMotion& motion : report.free_motions) motion.point += matcher_->target().origin;
  report.status = status_of(attempt);
  const bool is_astray = report.status == FrameStatus::Lost || report.status == FrameStatus::Doubtful;
  num_lost_ = is_astray ? num_lost_ + 1 : 0;
  if (report.status == FrameStatus::Lost) return report;
  report.world_from_camera = attempt.world_from_sensor;
  usual_agreement_ += (usual_agreement_ == 0.0 ? 1.0 : kForgetting) * (attempt.agreement - usual_agreement_);
  if (is_astray) return report;
  if (attempt.gain_of_deskewing) gain_of_deskewing_ += *attempt.gain_of_deskewing, ++num_trials_;
  const double error = moved(guess, attempt.world_from_sensor, kTypicalDistanceVoxels * voxel_size_);
  prediction_error_ = std::max(error, (1.0 - kForgetting) * prediction_error_);
  before_last_ = last_;
  last_ = StampedPose{stamp_s, report.world_from_camera};
  const Rigid3 since = inverse(keyframe_->world_from_sensor) * report.world_from_camera;
  report.is_keyframe = !is_astray && (since.translation.norm() > options_.keyframe_distance_voxels * voxel_size_ ||
                                      angle_between(since, Rigid3{}) > options_.keyframe_angle);
  if (report.is_keyframe) merge(attempt);
  return report;
}

FrameReport LidarOdometry::add(double stamp_s, const Cloud& scan, const SweepShares& shares) {
  require(shares.empty() || shares.size() == scan.size(), "shares", static_cast<double>(shares.size()),
          "must be none, or one a point");
  if (!std::isfinite(stamp_s) || (last_stamp_s_ && stamp_s <= *last_stamp_s_)) {
    FrameReport report;
    report.stamp_s = stamp_s;
    report.segment = segment_;
    report.status = FrameStatus::OutOfOrder;
    return report;
  }
  const double before = shortest_gap_s_;
  if (last_stamp_s_) {
    const double gap_s = stamp_s - *last_stamp_s_;
    shortest_gap_s_ = before == 0.0 ? gap_s : std::min(before, gap_s);
  }
  try {
    const FrameReport report = placed(stamp_s, scan, shares);
    last_stamp_s_ = stamp_s;
    return report;
  } catch (...) {
    shortest_gap_s_ = before;
    throw;
  }
}

Cloud LidarOdometry::map() const { return map_ ? map_->surfaces(Vec3d::Zero()) : Cloud{}; }

}  // namespace augicp
