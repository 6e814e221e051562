// SPDX-License-Identifier: MIT
// A LiDAR measures its points one after the other while it moves: when each was measured, and what it would have seen
// from one place.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "augicp/cloud/cloud.h"
#include "augicp/geometry/trajectory.h"

namespace augicp {

// When each point of a sweep was measured, as a share of the sweep: 0 for its first point, 1 for its last. Empty:
// unknown, or all at one moment.
using SweepShares = std::vector<float>;

// From times in any unit and from any zero. Empty where they are all the same. Throws std::invalid_argument for a time
// that is not finite.
SweepShares shares_from_times(std::span<const double> times);

// The unit of times, as a power of a thousandth of a second: 1 (seconds), 1e-3, 1e-6 or 1e-9 s. Of these the one with
// which the duration of a sweep, given in that unit, is nearest to what it is expected to take, by their ratio. Empty
// where none is within a factor of 30. REQUIRES: expected_s > 0.
std::optional<double> likely_time_unit_s(double duration_in_unit, double expected_s);

// For the points of a spinning sensor in the order in which it measured them, whatever the azimuth at which it began
// and however much of a revolution it made: by how far the azimuth about z has come. Empty where the points are in
// another order (ring by ring, sorted, downsampled), which shows as azimuths that do not advance evenly.
SweepShares shares_from_order(const Cloud& cloud);

// For one revolution, clockwise about z, that began and ended behind the sensor (negative x), in any order of the
// points: 0.5 (1 - atan2(y, x) / pi). KITTI's scanner turns this way.
SweepShares shares_from_azimuth(const Cloud& cloud);

// How a sensor moves during a sweep, in its own frame at the middle of the sweep. The unit of time is the sweep.
struct SweepMotion {
  Vec3d velocity = Vec3d::Zero();              // metres per sweep
  Vec3d acceleration = Vec3d::Zero();          // metres per sweep^2
  Vec3d rotation = Vec3d::Zero();              // radians per sweep, about this axis
  Vec3d angular_acceleration = Vec3d::Zero();  // radians per sweep^2

  // The pose at a share of the sweep in the frame of the middle (share 0.5), by second-order expansion.
  Rigid3 middle_from(double share) const;
};

// The motion during the last of three sweeps, from the poses at their middles: positions and rotations follow the
// parabolas through the three. Without `before_last`: the sensor keeps its velocity in its own frame, so that it
// follows an arc, as vehicles do. sweep_s: how long the last sweep takes. REQUIRES: stamps increase.
SweepMotion motion_of_last(const std::optional<StampedPose>& before_last, const StampedPose& last,
                           const StampedPose& now, double sweep_s);

// The motion of the sweep that is this number of sweeps later, with the same accelerations; earlier if negative.
SweepMotion later_by(double sweeps, const SweepMotion& motion);

// The points as seen from where the sensor was in the middle of the sweep. A cloud without shares stays as it is.
// Directions are rotated as well.
Cloud without_skew(const Cloud& cloud, const SweepShares& shares, const SweepMotion& motion, int num_threads);

// What without_skew() returned with one motion, as if it had been given another.
Cloud straightened_again(const Cloud& straight, const SweepShares& shares, const SweepMotion& before,
                         const SweepMotion& motion, int num_threads);

}  // namespace augicp
