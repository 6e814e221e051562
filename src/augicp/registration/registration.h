// SPDX-License-Identifier: MIT
// The whole job on two raw inputs, and its stages for those who want to time, cache or replace them:
//
//   two Scans --prepare_pair--> PreparedPair --register_pair--> Registration
//
// Poses here are between the clouds' frames, origins included: x_in_target = target_from_source * x_in_source, metres.
// Inside the library they are between the clouds' points. Bad data never throws: empty clouds, and clouds that do not
// overlap, give a status. Options out of their range throw std::invalid_argument; a requested end throws Interrupted.
// Thread safety: all functions may run concurrently. The results are bit-identical for any number of threads.
#pragma once

#include "augicp/registration/options.h"
#include "augicp/registration/prepared_pair.h"

namespace augicp {

// A result and what it was computed from. result.pairs indexes the points of the prepared scans.
struct Registration {
  AlignResult result;
  PreparedPair prepared;
};

// A scan of extended points: downsampled to one point a voxel unless it is an image; with directions and structures,
// estimated unless the cloud brought them; with gradients of the intensity if the options compare intensities.
Scan prepare(Scan scan, const Lengths& lengths, const RegistrationOptions& options);

// Both scans, with the lengths that lengths_for() derives from them.
PreparedPair prepare_pair(Scan source, Scan target, const RegistrationOptions& options);

// Finds the motion between two prepared scans, and judges it.
Registration register_pair(PreparedPair pair, const Rigid3& initial_target_from_source = {},
                           const RegistrationOptions& options = {});

// The same for scans that stay where they are, as those of a sequence do.
AlignResult register_prepared(const ScanPair& pair, const Rigid3& initial_target_from_source,
                              const RegistrationOptions& options);

// prepare_pair() and register_pair().
Registration register_scans(Scan source, Scan target, const Rigid3& initial_target_from_source = {},
                            const RegistrationOptions& options = {});

}  // namespace augicp
