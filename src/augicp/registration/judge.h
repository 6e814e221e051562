// SPDX-License-Identifier: MIT
// From two scans and a pose to the numbers that trust/verdict.h decides by.
#pragma once

#include <memory>

#include "augicp/align/align.h"
#include "augicp/match/matcher.h"
#include "augicp/registration/prepared_pair.h"

namespace augicp {

// Pairs along lines of sight, for which the scan must be a depth image, or with the nearest point. The scan must
// outlive it.
std::unique_ptr<ScanMatcher> matcher_for(const Scan& scan, bool projective);

// What the scans say of each other under a pose between their points. matcher: of the target, as it was registered
// with; the evidence itself is taken along lines of sight from every scan that is a depth image. It compares a few
// thousand points of each scan, evenly spread: they tell a share to a hundredth, in a small part of the registration's
// time.
Evidence gather_evidence(const ScanPair& pair, const ScanMatcher& matcher, const Rigid3& target_from_source,
                         const AlignOptions& options);

// A result of align() with its evidence, and its status by decide(). guess: where the search for it began.
AlignResult judged(AlignResult result, const ScanPair& pair, const ScanMatcher& matcher,
                   const Rigid3& guess_target_from_source, const AlignOptions& options);

}  // namespace augicp
