// SPDX-License-Identifier: MIT
#include "augicp/testing/poses.h"

#include <numbers>

namespace augicp::testing {

std::vector<Rigid3> awkward_poses() {
  std::mt19937 generator(7);
  std::vector<Rigid3> poses{Rigid3{}};
  for (double angle_rad : {1e-16, 1e-9, 1e-5, 1e-3, 0.7, 3.0, std::numbers::pi - 1e-7})
    for (double distance_m : {0.0, 1e-6, 1.0, 1e4}) poses.push_back(random_motion(generator, angle_rad, distance_m));
  return poses;
}

}  // namespace augicp::testing
