// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "augicp/registration/full_resolution.h"

namespace augicp {

// A start, and its place among those that are led on.
struct StartInTurn {
  Rigid3 target_from_source;
  Turn turn{};
};

// search_starts(), reported as the stage Search.
std::vector<Rigid3> searched(const ScanPair& pair, const Rigid3& guess, const RegistrationOptions& options);

// The judged result between two depth images from a start. Large images begin coarse, and those that rolling shutters
// bent are straightened on the way.
AlignResult from_start_of_images(const ScanPair& pair, const StartInTurn& start, const Guess& guess,
                                 const RegistrationOptions& options);

// The judged result from a guess: of the starts around it, if the options search. The guess itself is led on too if
// what was found on the way does not convince, or hardly constrains a motion. If that motion is free, the pose that
// stays at the guess is returned; else the evidence decides.
AlignResult from_guess_of_images(const ScanPair& pair, const Rigid3& guess, const RegistrationOptions& options);

}  // namespace augicp
