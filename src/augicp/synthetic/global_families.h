// SPDX-License-Identifier: MIT
// Pairs for registration without a guess, drawn from seeds: two clouds of one scene, or of two that share nothing.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "augicp/cloud/cloud.h"

namespace augicp::synthetic {

struct DrawnPair {
  Cloud source, target;
  std::optional<Rigid3> target_from_source;  // not set: the two have no common surface
};

struct GlobalFamily {
  std::string name;
  std::function<DrawnPair(unsigned seed)> draw;
  double length_scale = 1.0;  // of what counts as found, see GlobalPair
};

// Fragments of furnished rooms, of three views each; sides of objects; streets seen by a LiDAR. Of each a family with
// clouds of one scene, and one with clouds of two scenes, whose name ends in "apart".
std::vector<GlobalFamily> global_families();

}  // namespace augicp::synthetic
