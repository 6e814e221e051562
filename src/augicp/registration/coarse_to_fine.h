// SPDX-License-Identifier: MIT
#pragma once

#include "augicp/registration/options.h"

namespace augicp {

// The motion between two prepared scans, neither of them empty: from a guess to a start (search_start), on thinned
// images to a pose and the bend of rolling shutters (ReadoutMotion), and at full resolution to the result. What of this
// is done is up to the options; with none of it, this is align(). Iterations and history are those at full resolution.
AlignResult coarse_to_fine(const Scan& source, const Scan& target, const Rigid3& guess_target_from_source,
                           const Lengths& lengths, const RegistrationOptions& options);

}  // namespace augicp
