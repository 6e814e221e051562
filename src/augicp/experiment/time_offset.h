// SPDX-License-Identifier: MIT
#pragma once

#include <span>

#include "augicp/experiment/sequence.h"

namespace augicp {

// The offset between the stamps of a sequence and the clock of its truth.
struct TimeOffset {
  double offset_s = 0.0;         // read the truth at stamp + offset
  double spread_s = 0.0;         // largest minus smallest offset of three disjoint thirds of the pairs
  double median_rotation = 0.0;  // angle to the truth at this offset, radians
  double median_rotation_at_0 = 0.0;
  std::size_t num_pairs = 0;
};

// Options of the run that finds the offset of a sequence: up to 100 pairs of neighbouring frames, with the defaults,
// downsampled.
SequenceOptions time_offset_options(const SequenceOptions& options);

// The offset in [-0.1, 0.1] s with the least angle between the registered rotation (the end of a path) and the true
// one, in the mean of the better nine tenths, to 0.1 ms. For curves of a small gap. Throws std::invalid_argument if
// fewer than nine of them have a true motion at all these offsets.
TimeOffset find_time_offset(std::span<const SequenceCurve> curves, const Trajectory& truth);

}  // namespace augicp
