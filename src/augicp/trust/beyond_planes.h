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

// Whether each point of a cloud with directions is on one of its large planes, within a distance (metres): the walls,
// the floor and the ceiling of a room, the ground and the fronts of a street. Up to six, each with 2 % of the points.
std::vector<bool> on_large_planes(const Cloud& cloud, double distance);

// How well the points off the large planes agree with another cloud: their share that agrees, divided by that of the
// points on the planes. Under a right pose both lie equally well. Under a wrong one the walls of a room can fit while
// what stands in it does not. 1 if there are few of either. said: what the other cloud says of each point. Hidden
// points and those in free space are not counted.
double agreement_off_planes(std::span<const PointAgreement> said, const std::vector<bool>& is_on_plane);

}  // namespace augicp
