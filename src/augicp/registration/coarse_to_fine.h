// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include "augicp/registration/options.h"
#include "augicp/registration/prepared_pair.h"

namespace augicp {

// The motion between two prepared scans, neither of them empty: from a guess to a start (search_starts), or to one that
// needs no guess (global_starts), on coarse images to a pose and the motion during the readout of rolling shutters
// (ReadoutMotion), and at full resolution to the judged result. Options switch each part off; with none of them, this
// is align() and the verdict. Iterations and history are those at full resolution.
AlignResult coarse_to_fine(const ScanPair& pair, const Rigid3& guess_target_from_source,
                           const RegistrationOptions& options);

// The judged result between two clouds from poses that are known to fit, one or more: from the first of them, unless
// that is not supported and another is; Ambiguous if others fit as well. guess: where the search began, if there was a
// guess.
AlignResult from_known(const ScanPair& pair, const std::vector<Rigid3>& starts_target_from_source,
                       const std::optional<Rigid3>& guess_target_from_source, const RegistrationOptions& options);

// The judged results from all starts that need no guess (global_starts), the best first; that one Ambiguous if others
// fit as well. Empty if the scans have nothing alike.
std::vector<AlignResult> from_anywhere(const ScanPair& pair, const RegistrationOptions& options);

}  // namespace augicp
