// SPDX-License-Identifier: MIT
// From LiDAR scans, one after the other, to where the sensor was.
//
//   scan --without_skew, downsample--> points --align to SurfaceMap--> FrameReport (pose, status)
#pragma once

#include <memory>
#include <optional>
#include <stop_token>

#include "augicp/geometry/trajectory.h"
#include "augicp/match/matcher.h"
#include "augicp/objective/information.h"
#include "augicp/odometry/lidar_memory.h"
#include "augicp/odometry/odometry.h"
#include "augicp/odometry/self_check.h"
#include "augicp/odometry/skew_trial.h"
#include "augicp/odometry/standstill.h"
#include "augicp/odometry/surface_map.h"
#include "augicp/shutter/sweep.h"

namespace augicp {

// The moment of a sweep to which its pose refers: its first point, half of its time, or its last point.
enum class PoseInstant { Begin, Middle, End };
template <>
inline constexpr auto kWords<PoseInstant> = std::to_array<Word<PoseInstant>>({{PoseInstant::Begin, "begin"},
                                                                              {PoseInstant::Middle, "middle"},
                                                                              {PoseInstant::End, "end"}});

// Parts of the method that can be left out, to measure what each of them does.
struct LidarParts {
  InformationModel information = plane_information();  // of the pairs
  bool has_edges = true;                               // lines of several scans in a voxel are edges
  bool is_last_scan_alone = false;                     // a scan is registered to the one before it, not to the map
  bool averages_standstill = true;                     // poses of a sensor that stands still become their mean
};

struct LidarOptions {
  // Edge length of the map's voxels, metres. Not set: a part of the first scan's extent. Every other length is in
  // voxels, so that one set of defaults serves rooms and streets.
  std::optional<double> voxel_size;

  // A scan this far from the last keyframe, or turned this much, becomes the next one: voxels, radians. Scans between
  // keyframes are registered and not merged: what is wrong in them moves with the sensor and would confirm itself.
  double keyframe_distance_voxels = 2.0;
  double keyframe_angle = 0.2;

  // The map keeps what is within this distance of the sensor, voxels.
  double reach_voxels = 150.0;

  // Surfaces that a keyframe sees through leave the map: what has moved away, see seen_through.h. Off:
  // one of nine scans of a real corridor is no longer called degenerate with it.
  bool remove_seen_through = false;

  // Registration: the least gate on the distance between a point and a voxel's mean, voxels, and the distance from a
  // plane at which a point counts as on it, voxels.
  double gate_voxels = 1.0;
  double on_surface_voxels = 0.15;

  // Sweeps are straightened with the motion found, unless the first ones that bend show that they are straight already.
  // false: scans are used as they came.
  bool deskew = true;

  // Poses refer to this moment. The first one of a segment, and those of scans without shares, refer to the middle.
  PoseInstant pose_at = PoseInstant::Middle;

  // How long a sweep takes, seconds. 0: the shortest time between two scans so far. Stamps may be in any unit if this
  // is in the same one.
  double sweep_s = 0.0;

  // Where the prediction leads nowhere convincing, the pose is searched for, see search_start().
  bool search = true;

  // Where the weakest direction's part of the best one's information is below, the status is Degenerate.
  double min_observability = 4e-3;

  // A scan with less than this part of the usual share of points on the map's surfaces is doubtful, and is lost with
  // less than half of that.
  double min_agreement = 0.6;

  // The self-check: every so many scans, one is also registered directly to a single keyframe about this far back,
  // voxels (see self_check.h). Where the two contradict, the scan is Doubtful. 0: never.
  int check_every = 10;
  double check_distance_voxels = 15.0;

  // After this number of lost or doubtful scans in a row, the next one starts a new segment of the trajectory.
  int max_lost = 10;

  // 10^9 bytes. A scan is refused before any work if it and the map are expected to need more, see require_memory().
  // Not set: half of the machine's memory. Infinity: no bound.
  std::optional<double> max_memory_gb;

  LidarParts parts;

  bool covariance = false;  // see FrameReport; takes about a tenth of the time
  int num_threads = 0;      // 0: all the machine's
  std::stop_token stop{};

  // Throws std::invalid_argument naming the first field out of its range.
  void check() const;
};

// Tracks one LiDAR. Memory is bounded by the reach of the map, and by LidarOptions::max_memory_gb. Not for concurrent
// use; independent objects may be used concurrently.
class LidarOdometry {
 public:
  // Throws std::invalid_argument for options out of range.
  explicit LidarOdometry(const LidarOptions& options = {});

  // The next scan, in the sensor's frame. shares: see shares_from_times() and shares_from_order(); empty: all points at
  // one moment. Never throws for what scans or stamps are like: a scan that cannot be placed gets a status and no pose,
  // and the next one is tried again. Throws std::invalid_argument for shares that are neither empty nor one a point,
  // TooMuchMemory beyond options.max_memory_gb, and Interrupted after a request to stop or options.stop; everything
  // then is as before the call.
  FrameReport add(double stamp_s, const Cloud& scan, const SweepShares& shares = {}, const std::stop_token& stop = {});

  // The surfaces of the map, in the frame of the first scan.
  Cloud map() const;

  // The size of the map. It is bounded by the reach, and does not grow with the number of scans.
  std::size_t num_voxels() const { return map_ ? map_->num_voxels() : 0; }

  // What is kept, 10^9 bytes: an estimate.
  double memory_gb() const { return memory_for(0).gb(); }

  // How far around the sensor the map reaches, metres; 0 before the first scan.
  double reach() const { return options_.reach_voxels * voxel_size_; }

  // The voxel size in use, metres; 0 before the first scan.
  double voxel_size() const { return voxel_size_; }

  // Whether it is derived from the first scan, not given.
  bool derives_voxel_size() const { return !options_.voxel_size; }

 private:
  struct Attempt;  // one scan at one pose
  struct Start;
  struct Keyframe {
    Cloud cloud;
    Rigid3 world_from_sensor;
  };

  struct TimedScan {  // as it came
    Cloud cloud;
    SweepShares shares;
    StampedPose pose;
    SweepMotion motion;  // during its sweep
  };

  struct SkewTrial {
    TimedScan scan;
    bool is_bent = false;                  // this scan or the reference, by the motion
    bool restarts_map = false;             // the majority has changed
    std::optional<SkewEstimate> estimate;  // where one is
  };

  struct Accelerations {  // in the sensor's frame, per sweep^2
    Vec3d linear = Vec3d::Zero(), angular = Vec3d::Zero();
  };

  LidarMemory memory_for(std::size_t num_points) const;
  void require_memory_for(const Cloud& scan);
  double spans_since_last(double stamp_s) const;
  bool is_after_pause(double stamp_s) const;
  Rigid3 predicted(double stamp_s) const;
  Rigid3 predicted_evenly(double stamp_s) const;
  double unevenness_at(double stamp_s, const Rigid3& world_from_sensor) const;
  bool is_uneven(double stamp_s, const Rigid3& world_from_sensor) const;
  Accelerations beyond_arc(double stamp_s, const Rigid3& world_from_sensor) const;
  double sweep_s(double passed_s) const;
  SweepMotion motion_of_sweep(double stamp_s, const Rigid3& world_from_sensor) const;
  FrameReport added(double stamp_s, const Cloud& scan, const SweepShares& shares);
  FrameReport placed(double stamp_s, const Cloud& scan, const SweepShares& shares);
  void start_segment(const Cloud& scan, const SweepShares& shares, FrameReport& report);
  SweepMotion motion_of_start(double stamp_s, const Rigid3& world_from_sensor) const;
  void restart_map_with(const TimedScan& scan, bool is_skewed);
  void straighten_start(double stamp_s, const Cloud& scan, const SweepShares& shares);
  SurfaceMap empty_map() const;
  Attempt prepared(const Cloud& scan, const SweepShares& shares, const SweepMotion& motion) const;
  Attempt straightened(Attempt attempt, const Cloud& scan, const SweepShares& shares, const SweepMotion& motion) const;
  AlignOptions align_options() const;
  void align_to_map(const Rigid3& guess, double gate, Attempt& attempt,
                    const std::optional<FreeDirections>& free = {}) const;
  std::optional<Mat6d> covariance_of(const AlignResult& result, const Cloud& source) const;
  bool is_convincing(double stamp_s, const Attempt& attempt) const;
  Attempt from(const Start& start, const Cloud& scan, const SweepShares& shares) const;
  Attempt started(double stamp_s, const Cloud& scan, const SweepShares& shares) const;
  Attempt registered(double stamp_s, const Cloud& scan, const SweepShares& shares) const;
  Attempt straightened_by_itself(Attempt attempt, double stamp_s, const Cloud& scan, const SweepShares& shares) const;
  bool is_taken_as_skewed(const SweepShares& shares) const;
  bool may_show_skew(double stamp_s, const SweepShares& shares) const;
  SkewTrial tried_skew(const TimedScan& scan);
  Attempt registered_as_it_shows(double stamp_s, const Cloud& scan, const SweepShares& shares,
                                 std::optional<SkewTrial>& trial);
  bool is_bent(const SweepMotion& motion) const;
  void conclude(const SkewTrial& trial);
  void search(Attempt& attempt) const;
  bool is_check_due() const;
  bool is_search_due() const;
  bool wants_covariance() const;
  bool is_near_last(const Attempt& attempt) const;
  void settle(Attempt& attempt);
  std::optional<DriftCheck> checked(const Attempt& attempt) const;
  std::optional<Mat6d> covariance_at_sensor(const Attempt& attempt) const;
  FrameStatus status_of(double stamp_s, const Attempt& attempt) const;
  void remove_seen_through(const Attempt& attempt);
  void merge(double stamp_s, const Attempt& attempt);
  void describe(const Attempt& attempt, FrameReport& report) const;
  void follow(const Attempt& attempt, const Rigid3& guess, FrameReport& report);

  LidarOptions options_;
  double voxel_size_ = 0.0;
  std::size_t num_voxels_of_scan_ = 0;  // of the first one: what a scan may add to the map
  std::optional<SurfaceMap> map_;
  std::shared_ptr<const Cloud> surfaces_;
  std::shared_ptr<const Matcher> matcher_;
  std::optional<Keyframe> keyframe_;
  SelfCheck self_check_;
  Standstill standstill_;
  int num_since_check_ = 0;
  std::optional<TimedScan> start_scan_;            // until two more show how the sensor moved
  std::optional<StampedPose> before_last_, last_;  // of this segment
  Accelerations beyond_arc_;                       // averaged
  std::optional<double> last_stamp_s_;             // of any scan
  double shortest_gap_s_ = 0.0;
  std::optional<SweepMotion> last_shown_;  // of the last scan, where its own points showed it
  // Of the last scans, metres at the distance of a typical point: how far predictions were off, and constant rates.
  double prediction_error_ = 0.0, unevenness_ = 0.0;
  double usual_agreement_ = 0.0;
  SkewVotes skew_votes_;
  std::optional<TimedScan> skew_reference_;  // until the votes have decided
  bool has_bent_scans_ = false;              // the map, of scans that were straightened
  bool is_last_degenerate_ = false;
  int num_lost_ = 0;
  int segment_ = 0;
};

// A scan as seen at the moment to which its pose refers: deskewed with the motion of its report. As it came if the
// report has none, and if there are no shares. Throws std::invalid_argument unless there is one share a point.
Cloud deskewed(const Cloud& scan, const SweepShares& shares, const FrameReport& report, PoseInstant pose_at,
               int num_threads = 0);

}  // namespace augicp
