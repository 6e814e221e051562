// SPDX-License-Identifier: MIT
// How the sensor moved during a sweep, as the sweep's own points show it on the map. Poses of whole scans show it only
// where the motion changes evenly.
#pragma once

#include <optional>

#include "augicp/cloud/posed_pairs.h"
#include "augicp/shutter/sweep.h"

namespace augicp {

// What is known before about the motion.
struct MotionPrior {
  SweepMotion motion;  // with which the source was straightened
  double sigma;        // metres per sweep, and per sweep^2, that it moves a point wrongly: by shift and by turn each
  double typical_distance;  // metres, of that point from the sensor
  double correlation;       // metres: the errors of points in one cell of this width count as one
};

// The prior's motion, corrected by one step. Points p of the source, measured at shares t of the sweep, lie on planes
// (q, n) of the target:
//
//   e = n . (T Exp(a + s b + s^2/2 c) p - q),   s = t - 1/2
//
// The pose's increment a and the corrections b of rates and c of accelerations are found together, with the weights of
// the Geman-McClure kernel, and with the prior of b and c. The source's frame is the sensor's in the middle of the
// sweep. Empty if there are few pairs. REQUIRES: one share a point of the source; sigma, typical_distance, correlation
// > 0.
std::optional<SweepMotion> shown_motion(const PosedPairs& posed, const SweepShares& shares, const MotionPrior& prior);

}  // namespace augicp
