// SPDX-License-Identifier: MIT
// Whether scans are skewed as the times of their points say, or were taken at once, or are deskewed already.
#pragma once

#include <cmath>
#include <optional>
#include <vector>

#include "augicp/cloud/cloud.h"
#include "augicp/shutter/sweep.h"

namespace augicp {

// Points of a scan as it came, on planes, and by how much deskewing would move each of them.
struct SkewedScan {
  Cloud cloud;                  // in the sensor's frame in the middle of the sweep, with normals
  std::vector<Vec3f> movement;  // metres, one a point
  Rigid3 world_from_sensor;
};

// One point a cell of half a voxel, with the normal of its voxel. REQUIRES: one share a point.
SkewedScan skewed_scan(const Cloud& scan, const SweepShares& shares, const SweepMotion& motion,
                       const Rigid3& world_from_sensor, double voxel_size);

struct SkewEstimate {
  double share;      // of the skew that the times of points predict: 1 for sweeps as measured, 0 for straight scans
  double deviation;  // its standard deviation

  bool is_skewed() const { return share > 0.5; }

  // A vote counts if its deviation is small; it is clear if it is nearer to one answer than to none.
  bool counts() const { return deviation <= kMaxDeviation; }
  bool is_clear() const { return counts() && std::abs(share - 0.5) > 0.25; }

  // Larger deviations leave out what is systematic, as traffic and the pattern of the rings, which is then as large as
  // the difference between the two answers.
  static constexpr double kMaxDeviation = 0.04;
};

// Fits two scans as they came to each other, with pairs (p, q) of points on planes of normal n:
//
//   e = n . (T (p + a u) - (q + a v)),   u, v: movements of the points, a: their share, T: motion between the scans
//
// T and a are found together, from a = 1/2, so that neither answer is preferred. No map enters: it consists of deskewed
// scans or of others, and confirms what it consists of. Deviations are those of covariance.h, cell by cell. Empty
// if there are few pairs, or no minimum is reached.
std::optional<SkewEstimate> estimate_skew(const SkewedScan& reference, const SkewedScan& scan, double voxel_size,
                                          int num_threads);

// Collects estimates, and decides by a clear majority.
class SkewVotes {
 public:
  // is_change_free: nothing is lost if the answer changes with this estimate.
  void add(const std::optional<SkewEstimate>& estimate, bool is_change_free = false);

  // No further estimates are needed.
  bool is_decided() const;

  // The times of points are believed until three estimates more are against them than for them; or, after a clear
  // one against them while a change was free, where more are for them than against.
  bool is_skewed() const { return num_against_ < num_for_ + majority_; }

 private:
  int majority_ = 3;
  int num_tried_ = 0, num_for_ = 0, num_against_ = 0;
};

}  // namespace augicp
