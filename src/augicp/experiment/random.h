// SPDX-License-Identifier: MIT
// Random numbers that are the same on every platform, unlike the std distributions: they use only the bits of the
// generator.
#pragma once

#include <random>

#include "augicp/geometry/rigid3.h"

namespace augicp {

// Uniform in [low, high), and normal with standard deviation 1.
double uniform(std::mt19937& generator, double low, double high);
double gaussian(std::mt19937& generator);

// A seed for another generator.
inline unsigned some_seed(std::mt19937& generator) { return static_cast<unsigned>(generator()); }

// A unit vector, uniform on the sphere.
Vec3d random_direction(std::mt19937& generator);

// A motion by angle_rad about a random axis and by distance_m along another.
Rigid3 random_motion(std::mt19937& generator, double angle_rad, double distance_m);

}  // namespace augicp
