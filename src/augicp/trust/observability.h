// SPDX-License-Identifier: MIT
#pragma once

#include "augicp/objective/linearize.h"

namespace augicp {

// How well the data constrain the six directions of motion.
//
// Metres and radians are not comparable. Rotations are therefore taken about the centroid of the paired points and
// scaled by their radius of gyration: a rotation counts by the motion of a typical point, and the unit of length does
// not matter (Gelfand et al. 2003). A free direction has a small eigenvalue (Zhang and Singh 2016).
struct Observability {
  Vec6d information = Vec6d::Zero();  // of the six directions, divided by the largest, ascending; free ones first
  Mat6d directions = Mat6d::Zero();   // columns in that order: increments (metres, radians) about the target's zero

  Vec3d centroid = Vec3d::Zero();  // of the paired target points, metres
  double gyration = 0.0;           // their radius of gyration, metres

  // The number of directions with less information than this.
  int num_below(double min_information) const {
    return static_cast<int>((information.array() < min_information).count());
  }

  double weakest() const { return information[0]; }
};

// From the information of the pairs' positions without its softening: the part that Table 2 makes 1 / epsilon weaker
// keeps a step solvable, but measures nothing. With intensities, also from those of both points.
Observability observability(const PosedPairs& posed, const Objective& objective);

}  // namespace augicp
