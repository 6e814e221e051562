// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "augicp/cloud/correspondence.h"
#include "augicp/match/gates.h"
#include "augicp/search/kd_tree.h"

namespace augicp {

// Searches take long enough for blocks so small, of which few thousand points have several for each thread.
inline constexpr std::size_t kSearchesPerBlock = 512;

// For each pose the pairs of nearest points, as NearestMatcher::match() finds them; faster if the poses move each point
// by about its distance to the target or less. The target points that are nearest under any of the poses lie around the
// middle of the places to which the poses move a source point: they are searched once. tree: of the target.
std::vector<std::vector<Correspondence>> match_nearby(const Cloud& source, const Cloud& target, const KdTree& tree,
                                                      std::span<const Rigid3> poses, const Gates& gates,
                                                      int num_threads);

}  // namespace augicp
