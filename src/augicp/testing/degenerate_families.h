// SPDX-License-Identifier: MIT
// Clouds of shapes that some motions leave unchanged, and these motions.
#pragma once

#include <functional>
#include <random>
#include <string>
#include <vector>

#include "augicp/cloud/cloud.h"

namespace augicp::testing {

struct DegenerateFamily {
  std::string name;
  std::function<Vec3d(std::mt19937&)> draw_point;  // on the shape, metres
  std::vector<Vec6d> free_motions;                 // a basis: increments (metres, radians) about zero
  double noise = 0.0;                              // noise of a good sensor, standard deviation in metres
};

// A plane, a plane with faint bumps, two parallel planes, a corridor, steps, a cylinder, a sphere, a cone, a vase, a
// straight wire, a trough of two planes, and a spiral ramp.
std::vector<DegenerateFamily> degenerate_families();

// count points of the family's shape, each moved by normal noise of this standard deviation along every axis, metres.
Cloud draw(const DegenerateFamily& family, std::size_t count, double noise, std::mt19937& generator);

// The largest angle between a reported free motion and the space of the true ones, in radians, with rotations scaled by
// the gyration (metres) about the centroid: 0 if all reported ones are free.
double angle_to_free(const DegenerateFamily& family, const std::vector<Vec6d>& found, double gyration,
                     const Vec3d& centroid);

// The length of a motion after removal of its part along the free ones, metres, with rotations scaled likewise.
double held_part(const DegenerateFamily& family, const Vec6d& motion, double gyration, const Vec3d& centroid);

}  // namespace augicp::testing
