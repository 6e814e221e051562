// SPDX-License-Identifier: MIT
// Free motions of degenerate problems, as axes in the scene.
#pragma once

#include <vector>

#include "augicp/core/words.h"
#include "augicp/trust/observability.h"

namespace augicp {

// One motion that changes nothing in the measurements: along an axis, about it, or both.
struct FreeMotion {
  enum class Kind {
    Translation,  // along the axis
    Rotation,     // about the axis
    Screw,        // about the axis, and along it by pitch per radian
  };
  Kind kind = Kind::Translation;
  Vec3d axis = Vec3d::Zero();   // unit; it and its opposite are the same
  Vec3d point = Vec3d::Zero();  // on the axis, in the frame of the observability, metres: the point nearest to the
                                // paired points' centroid
  double pitch = 0.0;           // metres per radian, of a screw
};
template <>
inline constexpr auto kWords<FreeMotion::Kind> =
    std::to_array<Word<FreeMotion::Kind>>({{FreeMotion::Kind::Translation, "translation"},
                                           {FreeMotion::Kind::Rotation, "rotation"},
                                           {FreeMotion::Kind::Screw, "screw"}});

// A basis of the num_free weakest directions: translations first, then rotations. With several free rotations (a sphere
// has three) the axes are not unique. Places are between the target's points, without its origin.
std::vector<FreeMotion> free_motions(const Observability& observability, int num_free);

// How far an increment (metres, radians, about the target's zero) moves the paired points along the num_free weakest
// directions, in their gyration radii; 0 for points without extent.
double moved_along(const Observability& observability, int num_free, const Vec6d& increment);

}  // namespace augicp
