// SPDX-License-Identifier: MIT
// One scan at one pose, while LidarOdometry looks for where it belongs.
#pragma once

#include <optional>

#include "augicp/align/align.h"
#include "augicp/odometry/lidar_odometry.h"

namespace augicp {

struct LidarOdometry::Attempt {
  Cloud fine, source;
  AlignResult result;
  Rigid3 world_from_sensor;
  double agreement = 0.0, rmse = 0.0;
  int iterations = 0;
  std::optional<SweepMotion> motion;       // with which it was straightened
  bool shows_motion = false;               // that is what its own points show, see shown_motion.h
  SweepShares fine_shares, source_shares;  // of their points; empty if it was not
};

// From where a registration to the map begins.
struct LidarOdometry::Start {
  Rigid3 world_from_sensor;
  SweepMotion motion;  // with which the scan is straightened
  double gate_voxels;
  bool is_trusted;  // what is free then keeps to it
};

// No LiDAR measures farther: 26 km with the smallest voxels. The cells of what is nearer have keys of 21 bits an axis.
inline constexpr double kReachVoxels = 1 << 17;

// Another start, or another motion during the sweep, is better if it brings this many times the points onto surfaces.
// Where motions are free, all fit equally well, and the prediction is the better guess.
inline constexpr double kClearGain = 1.02;

// Two points share the voxel from which their directions come up to this far apart, voxels.
inline constexpr double kCorrelationVoxels = 2.0;

// The distance of a typical point, voxels: a rotation counts as what it moves a point there.
inline constexpr double kTypicalDistanceVoxels = 15.0;
inline double typical_distance(double voxel_size) { return kTypicalDistanceVoxels * voxel_size; }

// A motion between two scans predicts this many times its own time ahead: after longer gaps the sensor may as well have
// stopped. After the second number of times, a prediction that was wrong says nothing of the sensor's motion.
inline constexpr double kTrustedSpans = 3.0;
inline constexpr double kForgottenSpans = 10.0;

// The moment to which poses refer, as a share of the sweep.
inline double share_of(PoseInstant instant) {
  return instant == PoseInstant::Begin ? 0.0 : instant == PoseInstant::End ? 1.0 : 0.5;
}

// How far two poses are apart, metres: by their translations, and by what their rotations move a point at a distance.
inline double motion_between(const Rigid3& a, const Rigid3& b, double typical_distance) {
  return (a.translation - b.translation).norm() + typical_distance * angle_between(a, b);
}

// By how much two motions during a sweep move its points apart from its begin to its end, metres.
inline double bending_between(const SweepMotion& a, const SweepMotion& b, double typical_distance) {
  return (a.velocity - b.velocity).norm() + typical_distance * (a.rotation - b.rotation).norm();
}

}  // namespace augicp
