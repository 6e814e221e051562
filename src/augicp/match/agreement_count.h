// SPDX-License-Identifier: MIT
// Counts an Agreement. Internal.
#pragma once

#include <cmath>

#include "augicp/cloud/cloud.h"
#include "augicp/match/agreement.h"

namespace augicp {

// A point is near a surface within this many tolerances.
inline constexpr float kNearPerTolerance = 3.0f;

// Tests whether a point near a target point is on its surface, with an agreeing normal. REQUIRES: both clouds outlive
// it.
class SurfaceTest {
 public:
  SurfaceTest(const Cloud& source, const Cloud& target, const Rigid3& target_from_source, double min_cosine)
      : source_(source),
        target_(target),
        pose_(target_from_source),
        min_cosine_(static_cast<float>(min_cosine)),
        has_directions_(source.has_directions() && target.has_directions()),
        signed_normals_(normals_have_signs(source, target)) {}

  Vec3f moved(std::size_t source_index) const { return pose_ * source_.points[source_index]; }

  bool agrees(std::size_t source_index, const Vec3f& moved, std::size_t target_index, float tolerance) const {
    const Vec3f error = moved - target_.points[target_index];
    const bool is_planar = has_directions_ && target_.structures[target_index] == Structure::Planar;
    if (!is_planar) return error.norm() <= tolerance;
    const Vec3f& normal = target_.directions[target_index];
    if (std::abs(normal.dot(error)) > tolerance) return false;
    if (source_.structures[source_index] != Structure::Planar) return true;
    const float cosine = normal.dot(pose_.rotation * source_.directions[source_index]);
    return (signed_normals_ ? cosine : std::abs(cosine)) >= min_cosine_;
  }

 private:
  const Cloud& source_;
  const Cloud& target_;
  Rigid3f pose_;
  float min_cosine_;
  bool has_directions_;
  bool signed_normals_;
};

}  // namespace augicp
