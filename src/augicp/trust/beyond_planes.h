// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <vector>

#include "augicp/cloud/posed_pairs.h"
#include "augicp/match/agreement.h"

namespace augicp {

// The target points of the pairs that agree within the tolerance: on the target's surface, with an agreeing normal.
std::vector<std::uint32_t> agreeing_points(const PosedPairs& posed, const AgreementTolerance& tolerance);

// The share of these points of a cloud, in [0, 1], that are off the three planes with the most of them, by the
// tolerance's distance. Three planes fit any other three non-parallel ones; only the rest distinguishes one corner of a
// room from another. Planes are fitted through some of the points with normals; 1 if there are none.
double share_beyond_planes(const Cloud& cloud, std::span<const std::uint32_t> points,
                           const AgreementTolerance& tolerance);

}  // namespace augicp
