// SPDX-License-Identifier: MIT
#pragma once

#include "augicp/registration/full_resolution.h"
#include "augicp/registration/registration.h"

namespace augicp {

// Whether a pair may be prepared again in smaller balls: both scans are clouds, their lengths are derived, and the
// preset is not the paper's.
bool may_have_finer_balls(const Scan& source, const Scan& target, const RegistrationOptions& options);

// `first`, or the registration in balls and voxels half as wide that follows it. A direction with almost no information
// may be one that the balls smooth away: the leg of a chair within a ball is a rod, the bolts of a flange are a rough
// ring. The scans speak of such a motion (motion_probe.h), but only by whole radii. If clouds are found to fit at a
// pose with such a direction, they are aligned again from there, and from the other poses that fit. The second result
// replaces the first if
//
//   * it is Converged or Ambiguous, and the first scans and tolerances support its pose too: a finer ball sees less of
//     a part that leaves a surface, or
//   * it is Degenerate at the same pose (within such a ball), so that finer balls see no more of that motion.
//
// raw: the scans before prepare_pair(). guess: where the search began. Poses are between the clouds' points. Iterations
// and history are those of the result that is returned. Throws Interrupted once an end is requested.
Registration in_finer_balls(Registration first, const RawPair& raw, const Guess& guess_target_from_source,
                            const RegistrationOptions& options);

}  // namespace augicp
