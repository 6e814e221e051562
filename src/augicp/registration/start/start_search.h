// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "augicp/registration/scan_match.h"

namespace augicp {

// Starts from which the scans at full resolution may meet, found on a few points, the most plausible first: the guess,
// and the guess rotated many ways; each led on by a few iterations, and the most plausible ones led on with more
// points. Between images the rotations are tried only if the guess leads nowhere convincing. The guess itself if
// nothing better was found. Both scans must be prepared.
std::vector<Rigid3> search_starts(const ScanPair& pair, const Rigid3& guess_target_from_source,
                                  const RegistrationOptions& options);

}  // namespace augicp
