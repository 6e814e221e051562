// SPDX-License-Identifier: MIT
#include "augicp/experiment/random.h"

#include <cmath>
#include <numbers>

#include "augicp/geometry/rotation.h"

namespace augicp {

double uniform(std::mt19937& generator, double low, double high) {
  return low + (high - low) * (static_cast<double>(generator()) + 0.5) / 4294967296.0;
}

double gaussian(std::mt19937& generator) {
  const double radius = std::sqrt(-2.0 * std::log(uniform(generator, 0.0, 1.0)));
  return radius * std::cos(uniform(generator, 0.0, 2.0 * std::numbers::pi));
}

Vec3d random_direction(std::mt19937& generator) {
  const double x = gaussian(generator), y = gaussian(generator), z = gaussian(generator);
  return Vec3d(x, y, z).normalized();
}

Rigid3 random_motion(std::mt19937& generator, double angle_rad, double distance_m) {
  const Vec3d axis = random_direction(generator);
  return {rotation_exp(angle_rad * axis), distance_m * random_direction(generator)};
}

}  // namespace augicp
