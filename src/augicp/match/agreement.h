// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>

namespace augicp {

// Tolerance within which a source point agrees with the target.
struct AgreementTolerance {
  double distance = 0.0;     // metres, above 0
  double per_depth = 0.0;    // metres more per metre of depth in front of the target's camera, if it has one
  double min_cosine = 0.85;  // between the normals of two planar points

  // Throws std::invalid_argument unless the distances are finite, at least 0, and one of them above.
  void check() const;
};

// What a target says of a source point under a pose.
enum class PointAgreement : std::uint8_t {
  Agree,     // on the target's surface, with its direction
  Differ,    // near the surface, but off it or rotated
  Conflict,  // clearly in front of what the target's camera saw: it saw through this point
  Hidden,    // clearly behind it (occluded)
  Unseen,    // out of view, or the target has no data there
};

// The number of source points of which a target says each.
struct Agreement {
  std::int64_t agree = 0, differ = 0, conflict = 0, hidden = 0, unseen = 0;

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

Agreement counted(std::span<const PointAgreement> points);

// Whether points agree under one pose rather than under another, beyond chance: of those that are visible under both,
// the ones that agree under the first alone exceed the others by four deviations of their number. One entry a point
// in both.
bool agree_on_more(std::span<const PointAgreement> points, std::span<const PointAgreement> with);

}  // namespace augicp
