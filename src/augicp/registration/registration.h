// SPDX-License-Identifier: MIT
// The whole job on two raw inputs, and its stages for those who want to time, cache or replace them:
//
//   Scan --prepare--> extended points --register_prepared--> AlignResult
#pragma once

#include "augicp/registration/options.h"

namespace augicp {

// A scan of extended points: thinned to one point a voxel unless it is an image, directions and structures estimated
// unless the cloud brought them, and gradients of the intensity where that is to count. May be empty.
Scan prepare(Scan scan, const Lengths& lengths, const RegistrationOptions& options);

// A source and a target, side by side: what of one is no work for several threads runs beside the other's.
struct ScanPair {
  Scan source, target;
};
ScanPair prepare_both(Scan source, Scan target, const Lengths& lengths, const RegistrationOptions& options);

// Finds the motion between two prepared scans. initial_target_from_source is between the clouds' frames.
AlignResult register_prepared(const Scan& source, const Scan& target, const Rigid3& initial_target_from_source,
                              const Lengths& lengths, const RegistrationOptions& options);

// Both, with the lengths for this pair. Never throws for what the data are like, only for options out of their range:
// an empty cloud or one that does not fit gives a status.
AlignResult register_scans(const Scan& source, const Scan& target, const Rigid3& initial_target_from_source = {},
                           const RegistrationOptions& options = {});

}  // namespace augicp
