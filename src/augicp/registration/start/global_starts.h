// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "augicp/global/seed_poses.h"
#include "augicp/registration/scan_match.h"

namespace augicp {

struct GlobalStarts {
  std::vector<Rigid3> starts_target_from_source;  // the most plausible first; none if nothing is alike
  std::vector<SeedPose> seeds;                    // the candidates, the best supported first
};

// Starts that need no guess, from which the scans at full resolution may meet: candidate_poses(), of which those that
// agreement and free space on few points make most plausible are led on by a few iterations, and of these the most
// plausible ones with more points. Both scans must be prepared.
GlobalStarts global_starts(const ScanPair& pair, const RegistrationOptions& options);

}  // namespace augicp
