// SPDX-License-Identifier: MIT
// The surfaces of generated scenes, each with exact ray casting. World frame, metres.
#pragma once

#include <optional>
#include <variant>

#include "augicp/core/types.h"

namespace augicp::testing {

// Every surface is seen from both sides.
struct Plane {
  Vec3d point;
  Vec3d normal;  // unit
};

// A finite planar patch: corner + a * side_u + b * side_v with a and b in [0, 1]. The sides are orthogonal.
struct Rectangle {
  Vec3d corner;
  Vec3d side_u;
  Vec3d side_v;
  Vec3d across = side_u.cross(side_v);  // follows from the sides; of any length
};

struct Sphere {
  Vec3d center;
  double radius;
};

// The curved surface only, without caps. A thin one is a wire, a thick one a pipe.
struct Cylinder {
  Vec3d begin;
  Vec3d end;
  double radius;
};

using Surface = std::variant<Plane, Rectangle, Sphere, Cylinder>;

struct Ray {
  Vec3d origin;
  Vec3d direction;  // any length above 0
};

struct Hit {
  double distance;  // in lengths of the ray's direction
  Vec3d normal;     // unit, on the side that the ray came from
};

// The first point in front of the ray's origin, or nothing.
std::optional<Hit> intersect(const Surface& surface, const Ray& ray);

}  // namespace augicp::testing
