// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <cstdint>
#include <vector>

#include "augicp/cloud/gather.h"
#include "augicp/geometry/rigid3.h"
#include "augicp/match/gates.h"

namespace augicp {

// The gates for one pair of clouds under one pose. REQUIRES: both clouds outlive it.
class PairFilter {
 public:
  // target_from_source maps between the clouds' points, without their origins.
  PairFilter(const Cloud& source, const Cloud& target, const Rigid3& target_from_source, const Gates& gates);

  Vec3f moved(std::uint32_t source_index) const { return pose_ * source_.points[source_index]; }
  float max_distance_sq() const { return max_distance_sq_; }

  // Applies all gates. The distance is measured from the moved source point.
  bool passes(std::uint32_t source_index, const Vec3f& moved_source, std::uint32_t target_index) const {
    if (!((target_.points[target_index] - moved_source).squaredNorm() <= max_distance_sq_)) return false;
    return directions_agree(source_index, target_index);
  }

  // Appends those of at most kGatheredAtOnce candidates that pass, in their order, many at a time. The result is that
  // of passes(), except for the last digits at the limit of a gate. REQUIRES: both runs have the same number of
  // indices.
  void append_passing(const IndexRuns& sources, const IndexRuns& targets, std::vector<Correspondence>& pairs) const;

 private:
  bool directions_agree(std::uint32_t source_index, std::uint32_t target_index) const {
    if (!compares_angles_ && !same_structure_) return true;
    const Structure of_source = source_.structures[source_index], of_target = target_.structures[target_index];
    if (of_source != of_target) return !same_structure_ || of_source == Structure::None || of_target == Structure::None;
    if (!compares_angles_ || of_target == Structure::None) return true;
    const float cosine = target_.directions[target_index].dot(pose_.rotation * source_.directions[source_index]);
    const bool with_sign = signed_normals_ && of_target == Structure::Planar;
    return (with_sign ? cosine : std::abs(cosine)) >= min_cosine_;
  }

  const Cloud& source_;
  const Cloud& target_;
  Rigid3f pose_;
  float max_distance_sq_;
  float min_cosine_;
  bool compares_angles_;
  bool same_structure_;
  bool signed_normals_;
};

}  // namespace augicp
