// SPDX-License-Identifier: MIT
// Registration of two raw inputs, and its stages for users who time, cache or replace them:
//
//   two Scans --prepare_pair--> PreparedPair --register_pair--> Registration
//
// Poses here are between the clouds' frames, origins included: x_in_target = target_from_source * x_in_source, metres.
// Inside the library they are between the clouds' points.
//
// Bad data never throws: empty and non-overlapping clouds give a status. Options out of their range throw
// std::invalid_argument; a requested end throws Interrupted. Thread safety: all functions may run concurrently. Results
// are bit-identical for any number of threads.
#pragma once

#include <vector>

#include "augicp/registration/options.h"
#include "augicp/registration/prepared_pair.h"

namespace augicp {

// A result and its inputs. result.pairs are indices of points of the prepared scans.
struct Registration {
  AlignResult result;
  PreparedPair prepared;
};

// A scan of extended points. It is downsampled to one point per voxel unless it is an image. Directions and structures
// are estimated unless the cloud has them, and gradients of the intensity if the options compare intensities.
Scan prepare(Scan scan, const Lengths& lengths, const RegistrationOptions& options);

// Both scans, with the lengths that lengths_for() derives from them.
PreparedPair prepare_pair(Scan source, Scan target, const RegistrationOptions& options);

// Both scans with given lengths, side by side on the threads.
PreparedPair prepare_both(RawPair raw, const Lengths& lengths, const RegistrationOptions& options);

// Finds the motion between two prepared scans, and judges it.
Registration register_pair(PreparedPair pair, const Rigid3& initial_target_from_source = {},
                           const RegistrationOptions& options = {});

// The same for scans that stay in place, for instance those of a sequence.
AlignResult register_prepared(const ScanPair& pair, const Rigid3& initial_target_from_source,
                              const RegistrationOptions& options);

// prepare_pair() and register_pair().
Registration register_scans(Scan source, Scan target, const Rigid3& initial_target_from_source = {},
                            const RegistrationOptions& options = {});

// One of several poses. result.pairs are indices of points of the scans that prepare_both() makes with these lengths.
struct FoundPose {
  AlignResult result;
  Lengths lengths;
};

// The motion between two raw scans of which nothing is known: every pose that was found, the best first, each with its
// evidence. The first has the status that register_scans() gives with RegistrationOptions::global, the others
// have those that they would have alone, but none that differs clearly from the first is Converged. Empty if the scans
// have nothing alike. Throws std::invalid_argument for the paper's preset.
std::vector<FoundPose> find_pose(Scan source, Scan target, RegistrationOptions options = {});

}  // namespace augicp
