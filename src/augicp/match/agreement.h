// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

namespace augicp {

// Tolerance within which a source point agrees with the target.
struct AgreementTolerance {
  double distance = 0.0;     // metres, above 0
  double per_depth = 0.0;    // metres more per metre of depth in front of the target's camera, if it has one
  double min_cosine = 0.85;  // between the normals of two planar points

  // Throws std::invalid_argument unless the distances are finite, at least 0, and one of them above.
  void check() const;
};

// What a target shows of a source under a pose. Each source point is counted once.
struct Agreement {
  std::int64_t agree = 0;     // on the target's surface, with its direction
  std::int64_t differ = 0;    // near the surface, but off it or rotated
  std::int64_t conflict = 0;  // clearly in front of what the target's camera saw: it saw through this point
  std::int64_t hidden = 0;    // clearly behind it (occluded) (occluded)
  std::int64_t unseen = 0;    // out of view, or the target has no data there

  std::int64_t seen() const { return agree + differ + conflict + hidden; }
  std::int64_t total() const { return seen() + unseen; }

  Agreement& operator+=(const Agreement& other) {
    agree += other.agree;
    differ += other.differ;
    conflict += other.conflict;
    hidden += other.hidden;
    unseen += other.unseen;
    return *this;
  }
  bool operator==(const Agreement&) const = default;
};

}  // namespace augicp
