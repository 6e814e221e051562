// SPDX-License-Identifier: MIT
// What the data leave open, in the terms of somebody who looks at the scene.
#pragma once

#include <string_view>
#include <vector>

#include "augicp/trust/observability.h"

namespace augicp {

// One motion that changes nothing in what was seen: along an axis, about it, or both at once.
struct FreeMotion {
  enum class Kind {
    Translation,  // along the axis
    Rotation,     // about the axis
    Screw,        // about the axis, and along it by pitch for each radian
  };
  Kind kind = Kind::Translation;
  Vec3d axis = Vec3d::Zero();  // unit; it and its opposite are the same
  Vec3d point =
      Vec3d::Zero();   // on the axis, in the frame of the observability, metres: nearest to the paired points' centroid
  double pitch = 0.0;  // metres a radian, of a screw
};
std::string_view name_of(FreeMotion::Kind kind);

// The span of the num_free weakest directions, told by translations first, then by turns. Where several turns are free
// (a sphere: three) their axes are one choice of many. Places are between the target's points, without its origin.
std::vector<FreeMotion> free_motions(const Observability& observability, int num_free);

}  // namespace augicp
