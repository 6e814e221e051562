// SPDX-License-Identifier: MIT
#pragma once

#include "augicp/registration/full_resolution.h"

namespace augicp {

// The result between two prepared clouds, unless it may have slid: it converged, has less information along some
// direction than the loop's limit, and a step of a ball's radius ahead or back takes hardly more points off the
// surfaces than onto them (MotionProbe::held_along). Different starts then end at different poses along that direction,
// and the evidence supports each. It is named as free: the result is Degenerate, or Doubtful if it is not at the guess
// along it. To be asked last: smaller balls may hold what these do not. The pose, between the clouds' points, stays.
AlignResult unless_slid(AlignResult result, const ScanPair& pair, const Guess& guess_target_from_source,
                        const RegistrationOptions& options);

}  // namespace augicp
