// SPDX-License-Identifier: MIT
// The curves of a sequence against its true trajectory.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "augicp/experiment/pose_error.h"
#include "augicp/experiment/sequence.h"
#include "augicp/experiment/spread.h"

namespace augicp {

// The true target_from_source of a curve: the truth is interpolated at the frames' stamps + time_offset_s. Empty if the
// truth does not cover them, or has a hole of more than 0.1 s.
std::optional<Rigid3> true_motion(const SequenceCurve& curve, const Trajectory& truth, double time_offset_s);

// The errors of all pairs of one kind after one iteration.
struct SequenceRow {
  double time_offset_s = 0.0;
  std::size_t gap = 0;
  Preset preset = Preset::Default;
  Method method = Method::Augmented;
  int iteration = 0;             // 0: the guess
  std::size_t num_pairs = 0;     // pairs with a true motion
  Spread translation, rotation;  // metres, radians
  double success = 0.0;          // share within 5 cm and 2 degrees
  double success_narrow = 0.0;   // within 2 cm and 1 degree
};

// One row per kind and iteration; kinds in the order in which they first appear. Kinds without any true motion are left
// out.
std::vector<SequenceRow> summarize(std::span<const SequenceCurve> curves, const Trajectory& truth,
                                   double time_offset_s);

}  // namespace augicp
