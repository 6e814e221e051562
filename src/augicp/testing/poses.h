// SPDX-License-Identifier: MIT
#pragma once

#include <random>
#include <vector>

#include "augicp/geometry/rigid3.h"

namespace augicp::testing {

// A unit vector, uniform on the sphere. The same on every platform: it uses only the generator's bits.
Vec3d random_direction(std::mt19937& generator);

// A motion by angle_rad about a random axis and by distance_m along another.
Rigid3 random_motion(std::mt19937& generator, double angle_rad, double distance_m);

// Uniform in [low, high), and normal with standard deviation 1; platform independent, unlike the std distributions.
double uniform(std::mt19937& generator, double low, double high);
double gaussian(std::mt19937& generator);

// Identity, tiny, near pi, far away and random: the poses on which laws break first.
std::vector<Rigid3> awkward_poses();

}  // namespace augicp::testing
