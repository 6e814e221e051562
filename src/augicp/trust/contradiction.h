// SPDX-License-Identifier: MIT
// Two scans of the same scene may end at different places, but where one goes on, the other cannot leave its surface.
#pragma once

#include <span>

#include "augicp/cloud/cloud.h"
#include "augicp/geometry/rigid3.h"
#include "augicp/match/agreement.h"

namespace augicp {

// A cloud, and where it lies beside the one that is asked about.
struct PosedCloud {
  const Cloud& cloud;
  Rigid3 this_from_asked;
  double radius;  // of the balls in which its surface is estimated, metres
};

// The share of a cloud's points, in [0, 1], in its largest connected part that contradicts another cloud under a pose:
// a part off the other's surface, which begins where that surface goes on to all sides. A mug's handle beside the bare
// side of another mug is such a part. What the other scan merely does not reach begins at a border of that scan, and a
// hole is a border too. A part may begin at both: a wall whose foot stands in the middle of the other's floor, with all
// that is behind it. Of such a part those points count, by 0.6, that are nearer, in links between neighbours, to where
// the other surface goes on. Scan lines far apart have borders everywhere, and contradict nothing.
//
// said: what the other cloud says of each point under the pose. Points of both clouds are evenly spread samples, a few
// thousand. Thread safety: none needed. The result is the same for the same input.
double contradicting_share(const Cloud& cloud, std::span<const PointAgreement> said, const PosedCloud& other);

}  // namespace augicp
