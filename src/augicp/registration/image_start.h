// SPDX-License-Identifier: MIT
#pragma once

#include "augicp/registration/full_resolution.h"

namespace augicp {

// The judged result between two depth images from a start. Large images begin coarse, and those that rolling shutters
// bent are straightened on the way.
AlignResult from_start_of_images(const ScanPair& pair, const Rigid3& start_target_from_source, const Guess& guess,
                                 const RegistrationOptions& options);

// The judged result from a guess: of the starts around it, if the options search. The guess itself is led on at full
// resolution only if what was found on the way does not convince.
AlignResult from_guess_of_images(const ScanPair& pair, const Rigid3& guess, const RegistrationOptions& options);

}  // namespace augicp
