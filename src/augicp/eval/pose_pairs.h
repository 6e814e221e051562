// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "augicp/eval/matched_poses.h"

namespace augicp {

enum class DeltaUnit {
  Frames,   // matched poses; a pose without a partner is not counted
  Seconds,  // between the estimate's stamps
  Metres,   // along the true path from matched pose to matched pose
};

// Over what distance two poses are compared with each other.
struct DeltaOptions {
  double delta = 1.0;  // in units of unit; a whole number for frames
  DeltaUnit unit = DeltaUnit::Frames;
  // False: from every pose. True: each pair starts where the one before it ends, the first at the first pose.
  bool consecutive = false;

  // Throws std::invalid_argument naming the first field out of its range.
  void check() const;
};

struct PosePair {
  std::size_t first = 0, second = 0;  // first < second
};

// The pairs of poses that are delta apart, ordered by their first pose. Empty where the trajectory is shorter.
//
// From every pose: the second is the later one whose distance from the first is nearest to delta, the earlier of two
// that are equally near. Frames must be exact; in the other units it is no pair where the distance is off by more than
// a tenth of delta. So evo has it in frames and metres (all_pairs, rel_delta_tol = 0.1), except that its path is the
// estimate's unless told otherwise (pairs_from_reference): here the pairs are the same for every estimate. The TUM
// benchmark's evaluate_rpe.py (fixed_delta) has no tolerance, and instead leaves out what ends at the last pose.
//
// Consecutive: the second is the first pose that is at least delta away. So evo has it, except that in metres evo
// begins delta after the start.
std::vector<PosePair> pairs_at_delta(std::span<const MatchedPose> poses, const DeltaOptions& options = {});

}  // namespace augicp
