// SPDX-License-Identifier: MIT
#pragma once

#include "augicp/objective/linearize.h"

namespace augicp {

// How firmly the data hold the six directions of motion.
//
// Metres and radians do not compare, so rotations are taken about the centroid of the paired points and scaled by their
// radius of gyration: a turn then counts by how far it moves a typical point, and the unit of length does not matter
// (Gelfand et al. 2003; the loss of a direction shows as a small eigenvalue: Zhang and Singh 2016).
struct Observability {
  Vec6d information = Vec6d::Zero();  // of the six directions, each as a part of the best one's, ascending
  Mat6d directions = Mat6d::Zero();   // columns in that order: increments (metres, radians) about the target's zero

  Vec3d centroid = Vec3d::Zero();  // of the paired target points, metres
  double gyration = 0.0;           // their radius of gyration, metres

  // How many directions have less information than this.
  int num_below(double min_information) const {
    return static_cast<int>((information.array() < min_information).count());
  }

  double weakest() const { return information[0]; }
};

// Of the information of the pairs' positions without its softening: what is 1 / epsilon times weaker than the rest in
// Table 2 is there to keep a step solvable, not because it is known. And of what the intensities of both points hold,
// where they count.
Observability observability(const PosedPairs& posed, const Objective& objective);

}  // namespace augicp
