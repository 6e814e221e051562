// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "augicp/registration/scan_match.h"

namespace augicp {

// Starts that need no guess, from which the scans at full resolution may meet: candidate_poses(), of which those that
// agreement and free space on few points make most plausible are led on by a few iterations, and of these the most
// plausible ones with more points. The most plausible first; none if nothing is alike. Both scans must be prepared.
std::vector<Rigid3> global_starts(const ScanPair& pair, const RegistrationOptions& options);

}  // namespace augicp
