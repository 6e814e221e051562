// SPDX-License-Identifier: MIT
#pragma once

#include <span>

#include "augicp/cloud/cloud.h"
#include "augicp/global/seed_poses.h"

namespace augicp {

// How many times as many pairs of points that look alike support another pose as support this one: the largest support
// of a seed that differs clearly from the pose, divided by the largest of one near it. 0 if no seed differs clearly, or
// if none is near: of a pose that no pairs proposed they say nothing. A right pose is the best supported one, unless
// the scene repeats itself. A wrong one that fits by its large surfaces is one of many. Poses are between the clouds'
// points; radius: of the balls in which surfaces are estimated, metres.
double outvoted(const Cloud& source, const Rigid3& target_from_source, std::span<const SeedPose> seeds, double radius);

}  // namespace augicp
