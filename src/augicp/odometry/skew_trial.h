// SPDX-License-Identifier: MIT
// Whether scans are skewed as the times of their points say, or were taken at once, or are deskewed already.
#pragma once

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
  void add(const std::optional<SkewEstimate>& estimate);

  // No further estimates are needed.
  bool is_decided() const;

  // The times of points are believed until three estimates more are against them than for them.
  bool is_skewed() const { return num_against_ < num_for_ + kMajority; }

 private:
  static constexpr int kMajority = 3;

  int num_tried_ = 0, num_for_ = 0, num_against_ = 0;
};

}  // namespace augicp
