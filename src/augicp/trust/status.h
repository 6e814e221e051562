// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>

namespace augicp {

// What became of a registration. Only Converged is a pose to trust.
enum class AlignStatus {
  Converged,  // the steps have become small or lead round in a circle, and what the clouds say of each other speaks for
              // the pose
  IterationLimit,  // the steps have not become small, after max_iterations
  Degenerate,      // some direction of motion is not held by the data, see AlignOptions::min_observability
  TooFewPairs,     // fewer points in a cloud than pairs that six numbers need
  NoOverlap,       // hardly any source point has a partner
  Diverged,        // a number stopped being finite
  Doubtful,        // a pose was found, but the evidence speaks against it, see verdict.h
};
std::string_view name_of(AlignStatus status);

// Whether it ended with a pose of its own, to be trusted or not.
bool has_pose(AlignStatus status);

}  // namespace augicp
