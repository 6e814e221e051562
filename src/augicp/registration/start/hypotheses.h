// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "augicp/match/matcher.h"

namespace augicp {

// A pose, and how well both clouds speak for it.
struct Hypothesis {
  Rigid3 target_from_source;  // between the clouds' points
  double plausibility = 0.0;  // see plausibility(), both ways
  bool is_free = false;       // some motion that the clouds do not show leads to it as well
};

// What an agreement says of a pose, from 1 (all points are seen again) down. Where a pose is right, nearly all that is
// seen agrees, however little that is; a wrong one that fits much of the surface also has points where the target saw
// through, and behind what it saw. So these count several times: on pairs of fr1/desk, one wrong pose in a thousand has
// more than 0.42, half of the right ones at gap 10 have more than 0.54.
double plausibility(const Agreement& agreement);

// The guess, and the guess turned about a place in the target's frame: by each of the angles about fourteen axes spread
// over the sphere (those of a cube through its faces and corners).
std::vector<Rigid3> turned(const Rigid3& guess, const Vec3d& place_in_target, const std::vector<double>& angles_rad);

// The best of the hypotheses, best first, at most so many; of those that differ by less than both limits only the
// first.
std::vector<Hypothesis> best_of(std::vector<Hypothesis> hypotheses, std::size_t max_count, double min_distance,
                                double min_angle_rad);

}  // namespace augicp
