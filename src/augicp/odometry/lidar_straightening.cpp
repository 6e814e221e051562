// SPDX-License-Identifier: MIT
// How LidarOdometry prepares a scan: straightened with a motion, downsampled, and straightened again with another, or
// with the one that its own points show.
#include <algorithm>
#include <utility>

#include "augicp/cloud/voxel_grid.h"
#include "augicp/odometry/lidar_attempt.h"
#include "augicp/odometry/shown_motion.h"
#include "augicp/registration/far_outliers.h"

namespace augicp {
namespace {

// Points of one scan enter the map once in a cell of this part of a voxel, so that a near surface does not outweigh the
// others; those that are registered are once in a cell of half a voxel.
constexpr double kFineCellsPerVoxel = 4.0;
constexpr double kSourceCellsPerVoxel = 2.0;

// Two motions that put points at most this far apart, voxels, need no new choice of points: this is one cell of the
// map.
constexpr double kSameCellsVoxels = 0.25;

// While what a sweep's own points show moves them by more than this, voxels, it is straightened again. Each round finds
// a part of what the one before has left.
constexpr double kLeastBendVoxels = 0.01;
constexpr int kMaxOwnRounds = 10;

}  // namespace

Cloud deskewed(const Cloud& scan, const SweepShares& shares, const FrameReport& report, PoseInstant pose_at,
               int num_threads) {
  if (!report.motion || shares.empty()) return scan;
  const Cloud at_middle = without_skew(scan, shares, *report.motion, num_threads);
  return transform(at_middle, inverse(report.motion->middle_from(share_of(pose_at))));
}

LidarOdometry::Attempt LidarOdometry::prepared(const Cloud& scan, const SweepShares& shares,
                                               const SweepMotion& motion) const {
  Attempt attempt;
  const bool is_skewed = !shares.empty();
  Cloud cloud = is_skewed ? without_skew(scan, shares, motion, options_.num_threads) : scan;
  if (is_skewed) attempt.motion = motion, cloud.weights = shares;  // with which they are downsampled
  drop_far_outliers(cloud, kReachVoxels * voxel_size_);
  attempt.fine = downsample(cloud, voxel_size_ / kFineCellsPerVoxel);
  attempt.fine.directions.clear(), attempt.fine.structures.clear();
  attempt.source = downsample(attempt.fine, voxel_size_ / kSourceCellsPerVoxel);
  SurfaceMapOptions of_one_scan;
  of_one_scan.voxel_size = voxel_size_;
  SurfaceMap own(of_one_scan);
  own.add(attempt.fine, Rigid3{});
  own.describe(attempt.source, Rigid3{});
  if (is_skewed) attempt.fine_shares.swap(attempt.fine.weights), attempt.source_shares.swap(attempt.source.weights);
  return attempt;
}

// The same scan, straightened with another motion. Where this hardly moves points, those chosen before are moved: each
// with the share of the point nearest to its cell's mean.
LidarOdometry::Attempt LidarOdometry::straightened(Attempt attempt, const Cloud& scan, const SweepShares& shares,
                                                   const SweepMotion& motion) const {
  const SweepMotion before = *attempt.motion;
  if (bending_between(before, motion, typical_distance(voxel_size_)) > kSameCellsVoxels * voxel_size_)
    return prepared(scan, shares, motion);
  attempt.fine = straightened_again(attempt.fine, attempt.fine_shares, before, motion, options_.num_threads);
  attempt.source = straightened_again(attempt.source, attempt.source_shares, before, motion, options_.num_threads);
  attempt.motion = motion;
  return attempt;
}

// With the motion that the scan's own points show, where motion is uneven and while more of them then lie on surfaces.
// Where motions are free, they show nothing, and on a map of one scan whose own motion is unknown they show that one's.
LidarOdometry::Attempt LidarOdometry::straightened_by_itself(Attempt attempt, double stamp_s, const Cloud& scan,
                                                             const SweepShares& shares) const {
  const Rigid3& found = attempt.world_from_sensor;
  if (start_scan_ || attempt.result.status == AlignStatus::Degenerate || !is_uneven(stamp_s, found)) return attempt;
  const double typical = typical_distance(voxel_size_), sigma = std::max(unevenness_, unevenness_at(stamp_s, found));
  for (int round = 0; round < kMaxOwnRounds; ++round) {
    const Cloud& target = matcher_->target();
    const PosedPairs posed{attempt.source, target, attempt.result.pairs,
                           without_origins(attempt.world_from_sensor, attempt.source, target)};
    const MotionPrior prior{*attempt.motion, sigma, typical, kCorrelationVoxels * voxel_size_};
    const std::optional<SweepMotion> shown = shown_motion(posed, attempt.source_shares, prior);
    if (!shown || bending_between(*attempt.motion, *shown, typical) < kLeastBendVoxels * voxel_size_) break;
    Attempt again = straightened(attempt, scan, shares, *shown);
    align_to_map(attempt.world_from_sensor, options_.gate_voxels * voxel_size_, again);
    again.iterations += attempt.iterations;
    if (again.agreement < (round == 0 ? kClearGain : 1.0) * attempt.agreement) break;
    attempt = std::move(again);
    attempt.shows_motion = true;
  }
  return attempt;
}

}  // namespace augicp
