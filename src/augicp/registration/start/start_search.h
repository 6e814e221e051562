// SPDX-License-Identifier: MIT
#pragma once

#include "augicp/registration/scan_match.h"

namespace augicp {

// A start from which the clouds at full resolution meet, found on a few points: the guess, and where that leads nowhere
// convincing, the guess turned many ways; each led on by a few iterations, the most plausible ones led on with more
// points. The guess itself where nothing better was found. Both scans must be prepared.
Rigid3 search_start(const ScanPair& pair, const Rigid3& guess_target_from_source, const RegistrationOptions& options);

}  // namespace augicp
