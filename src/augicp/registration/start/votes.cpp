// SPDX-License-Identifier: MIT
#include "augicp/registration/start/votes.h"

#include <algorithm>

#include "augicp/registration/start/rivals.h"

namespace augicp {
namespace {

// Radii by which a seed may be off what it stands for, beyond what makes two poses clearly different: seeds this near
// are one, see candidate_poses().
constexpr double kOffPerRadius = 1.5;

}  // namespace

double outvoted(const Cloud& source, const Rigid3& target_from_source, std::span<const SeedPose> seeds, double radius) {
  double own = 0.0, other = 0.0;
  for (const SeedPose& seed : seeds) {
    const bool differs = differ_clearly(source, seed.target_from_source, target_from_source,
                                        (kClearlyPerRadius + kOffPerRadius) * radius);
    double& largest = differs ? other : own;
    largest = std::max(largest, seed.support);
  }
  return own > 0.0 ? other / own : 0.0;
}

}  // namespace augicp
