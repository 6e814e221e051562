// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <optional>

#include "augicp/align/align.h"

namespace augicp {

using KnowsPose = std::function<bool(const Rigid3& target_from_source)>;

// The pose to which the loop of align() leads, for callers who need nothing else: no observability is computed, and no
// direction counts as free. Empty if the loop finds no pose, or as soon as one of its poses is known: the caller then
// needs no better one. is_known is asked after each step. Intensities are not compared. Thread safety, poses and
// errors: as of align().
std::optional<Rigid3> scouted(const KnownClouds& clouds, const Rigid3& initial_target_from_source,
                              const AlignOptions& options, const KnowsPose& is_known);

}  // namespace augicp
