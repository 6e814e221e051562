// SPDX-License-Identifier: MIT
// The steps of one iteration of align(), in the order of the loop.
#pragma once

#include <vector>

#include "augicp/align/align.h"
#include "augicp/align/weighing.h"

namespace augicp {

// One iteration of section 3.3, from a pose to its step: all except the points themselves.
struct Iteration {
  Gates gates;
  std::vector<Correspondence> pairs;
  std::vector<Correspondence> typical;  // an even selection of the pairs, for medians
  Weighing weighing;
  Objective objective;
  NormalEquations equations;
};

// Counts the pairs into the result. Returns false, and sets the status, if there are too few for a step.
bool has_enough_pairs(const Cloud& source, const Cloud& target, const Iteration& iteration, AlignResult& result);

// Omega^p, Omega^l and K for the iteration's pairs: sets its typical pairs, weighing and objective.
void weigh(const PosedPairs& posed, const AlignOptions& options, Iteration& iteration);

// Eq. (10) without the num_free weakest directions. Not finite if the sums overflow.
Vec6d increment_of(const PosedPairs& posed, const Iteration& iteration, const AlignOptions& options, int num_free);

// The distance gate for the next iteration, see AlignOptions::gate_per_median. posed: the typical pairs under the new
// pose.
double closed_gate(const PosedPairs& posed, double gate, const AlignOptions& options);

bool is_small(const Vec6d& increment, const AlignOptions& options);

// Pairs change discontinuously, so a loop may cycle through a few poses for ever. True if the pose equals one of the
// last visited ones.
bool has_returned(const Rigid3& pose, const std::vector<Rigid3>& visited, const AlignOptions& options);

// Root mean square of the distances within the pairs, metres; 0 without pairs.
double rms_distance(const PosedPairs& posed, int num_threads);

}  // namespace augicp
