// SPDX-License-Identifier: MIT
#pragma once

#include "augicp/match/matcher.h"

namespace augicp {

// How well a scan lies on the surfaces of a target.
struct SurfaceAgreement {
  double share = 0.0;  // of the source's points that are on a surface, in [0, 1]
  double rmse = 0.0;   // of the distances of these points from it, metres
};

// on_surface: a point this near to a plane, or to the line of an edge, is on it, metres. The pose is between the frames
// of the clouds. The result is the same for any number of threads.
SurfaceAgreement surface_agreement(const Cloud& source, const Matcher& matcher, const Rigid3& target_from_source,
                                   const Gates& gates, double on_surface, int num_threads);

}  // namespace augicp
