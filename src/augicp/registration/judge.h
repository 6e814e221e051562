// SPDX-License-Identifier: MIT
// From two scans and a pose to the numbers that trust/verdict.h decides by.
#pragma once

#include <memory>

#include "augicp/align/align.h"
#include "augicp/match/matcher.h"
#include "augicp/registration/lengths.h"

namespace augicp {

// Pairs along lines of sight, for which the scan must be a depth image, or with the nearest point. The scan must
// outlive it.
std::unique_ptr<Matcher> matcher_for(const Scan& scan, bool projective);

// What the scans say of each other under a pose between their frames. matcher: of the target, as it was registered
// with; the evidence itself is taken along lines of sight from every scan that is a depth image. A few thousand points
// of each scan, evenly spread, are asked: a share of them is known to a hundredth, and it takes a small part of the
// registration's time.
Evidence gather_evidence(const Scan& source, const Scan& target, const Matcher& matcher,
                         const Rigid3& target_from_source, const Lengths& lengths, const AlignOptions& options);

// A result of align() with the evidence, and its status by decide(). guess: what the search for it began with.
AlignResult judged(AlignResult result, const Scan& source, const Scan& target, const Matcher& matcher,
                   const Rigid3& guess_target_from_source, const Lengths& lengths, const AlignOptions& options);

}  // namespace augicp
