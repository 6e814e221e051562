// SPDX-License-Identifier: MIT
#pragma once

#include "augicp/registration/scan_match.h"

namespace augicp {

// Poses whose points lie farther apart (RMS) than this many radii of the ball are clearly different.
inline constexpr double kClearlyPerRadius = 2.0;

// Whether a motion from one pose to another moves the source's points farther (RMS) than the limit, metres. Poses are
// between the clouds' points.
bool differ_clearly(const Cloud& source, const Rigid3& a, const Rigid3& b, double limit);

// Three orthogonal axes of a scene as columns: the normal that most planar points share within 10 degrees, the one that
// most of those across it share, and their cross product. The identity if fewer than two normals are known.
Mat3d scene_axes(const Cloud& cloud);

// Poses that differ clearly from one that was found, and may fit as well: those to which a few iterations on few points
// lead from the found pose, and that are nearly as plausible. It is rotated about the target's axes by quarter and half
// turns, and by those after which the target repeats itself (repeated_rotations.h), or moved along them. The most
// plausible first; none in most cases. Scans must be clouds, and prepared.
std::vector<Rigid3> search_rivals(const ScanPair& pair, const Rigid3& found_target_from_source,
                                  const RegistrationOptions& options);

}  // namespace augicp
