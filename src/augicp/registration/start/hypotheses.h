// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "augicp/core/angles.h"
#include "augicp/match/matcher.h"

namespace augicp {

// Candidates whose poses differ by less than this, and by less than a ball's radius, are one.
inline constexpr double kSameAngle = 3.0 * kRadPerDeg;

// A pose, and its plausibility.
struct Hypothesis {
  Rigid3 target_from_source;  // between the clouds' points
  double plausibility = 0.0;  // see plausibility(), in both directions
  bool is_free = false;       // a motion that the clouds do not constrain leads to it as well
};

// Plausibility of a pose, from 1 (all points agree) down. Under a right pose nearly all visible points agree, for any
// overlap. A wrong one that fits much of the surface also has points in free space and behind the surface. So these
// count several times. On pairs of fr1/desk, one wrong pose in a thousand has more than 0.42, and half of the right
// ones at gap 10 have more than 0.54.
double plausibility(const Agreement& agreement);

// The guess, and the guess rotated about a place in the target's frame, by each of the angles, about fourteen axes
// spread over the sphere (those of a cube through its faces and corners).
std::vector<Rigid3> turned(const Rigid3& guess, const Vec3d& place_in_target, const std::vector<double>& angles_rad);

// The best hypotheses, best first, at most max_count; of those that differ by less than both limits only the first.
std::vector<Hypothesis> best_of(std::vector<Hypothesis> hypotheses, std::size_t max_count, double min_distance,
                                double min_angle_rad);

}  // namespace augicp
