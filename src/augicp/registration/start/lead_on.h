// SPDX-License-Identifier: MIT
#pragma once

#include <span>

#include "augicp/registration/scan_match.h"
#include "augicp/registration/start/hypotheses.h"

namespace augicp {

// Size of the first level of a search. A thousand points are enough to tell thirty poses apart, and cost a millisecond
// each.
inline constexpr int kCoarseColumns = 40;
inline constexpr double kCoarseVoxels = 8.0;

// The poses to which align() leads from the starts, in their order, without those starts that lead to no pose. The
// result is the same for any number of threads.
std::vector<Hypothesis> led_on(const ScanMatch& level, std::span<const Rigid3> starts, const AlignOptions& options);

// The same without starts that come to a known pose. None is marked as free. See align/scout.h.
std::vector<Hypothesis> scouted(const ScanMatch& level, std::span<const Rigid3> starts, const AlignOptions& options,
                                const KnowsPose& is_known);

// The starts themselves, each with its plausibility. The result is the same for any number of threads.
std::vector<Hypothesis> as_they_are(const ScanMatch& level, std::span<const Rigid3> starts, int num_threads);

// The options for a start on few points: a start gives threads nothing to share.
AlignOptions on_one_thread(AlignOptions options);

}  // namespace augicp
