// SPDX-License-Identifier: MIT
#pragma once

#include "augicp/cloud/posed_pairs.h"

namespace augicp {

// How well a scan lies on the surfaces of a target.
struct SurfaceAgreement {
  double share = 0.0;  // of the source's points that are on a surface, in [0, 1]
  double rmse = 0.0;   // of the distances of these points from it, metres
};

// on_surface: a point this near to a plane, or to the line of an edge, is on it, metres.
SurfaceAgreement surface_agreement(const PosedPairs& posed, double on_surface);

}  // namespace augicp
