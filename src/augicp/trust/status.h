// SPDX-License-Identifier: MIT
#pragma once

#include "augicp/core/words.h"

namespace augicp {

// The outcome of a registration. Only Converged is a pose to trust.
enum class AlignStatus {
  Converged,       // the steps are small or repeat in a cycle, and both clouds support the pose
  IterationLimit,  // the steps are not small after max_iterations
  Degenerate,      // the data do not constrain some direction of motion, see AlignOptions::min_observability
  TooFewPairs,     // fewer points in a cloud than six numbers need
  NoOverlap,       // hardly any source point has a correspondence
  Diverged,        // a number is no longer finite
  Doubtful,        // a pose was found, but the evidence contradicts it, see verdict.h
  Ambiguous,       // the evidence supports a clearly different pose as well, see AlignResult::runners_up
};
template <>
inline constexpr auto kWords<AlignStatus> =
    std::to_array<Word<AlignStatus>>({{AlignStatus::Converged, "converged"},
                                      {AlignStatus::IterationLimit, "iteration_limit"},
                                      {AlignStatus::Degenerate, "degenerate"},
                                      {AlignStatus::TooFewPairs, "too_few_pairs"},
                                      {AlignStatus::NoOverlap, "no_overlap"},
                                      {AlignStatus::Diverged, "diverged"},
                                      {AlignStatus::Doubtful, "doubtful"},
                                      {AlignStatus::Ambiguous, "ambiguous"}});

// Whether there is a pose, to be trusted or not.
bool has_pose(AlignStatus status);

}  // namespace augicp
