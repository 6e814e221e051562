// SPDX-License-Identifier: MIT
// A generated scene: surfaces, the true creases between them, and a place to look from.
#pragma once

#include <vector>

#include "augicp/geometry/rigid3.h"
#include "augicp/testing/surfaces.h"

namespace augicp::testing {

// A segment along which two surfaces meet, or the axis of a wire; both numbers are then the wire's. Metres.
struct Crease {
  Vec3d begin;
  Vec3d end;
  int first_surface;
  int second_surface;

  Vec3d tangent() const { return (end - begin).normalized(); }
};

// World frame: z up. The number of a surface is its index in `surfaces`.
struct Scene {
  std::vector<Surface> surfaces;
  std::vector<Crease> creases;
  Rigid3 world_from_camera;  // a sensible place for a camera
};

// The pose of a camera at eye that looks at point, with an upright image. REQUIRES: the line of sight is not vertical.
Rigid3 look_at(const Vec3d& eye, const Vec3d& point);

int add_surface(Scene& scene, const Surface& surface);

// A box from -size / 2 to size / 2 in its own frame: six rectangles, twelve creases. Seen from inside it is a room.
struct BoxFaces {
  int left, right, front, back, bottom, top;  // at -x, +x, -y, +y, -z, +z
};
BoxFaces add_box(Scene& scene, const Rigid3& world_from_box, const Vec3d& size);

// A box on a horizontal surface, rotated by yaw_rad about the vertical; base is the centre of its foot. It has no
// bottom: its four bottom creases are those with the surface below.
BoxFaces add_standing_box(Scene& scene, const Vec3d& base, double yaw_rad, const Vec3d& size, int ground);

// A thin cylinder; its axis counts as a crease.
int add_wire(Scene& scene, const Vec3d& begin, const Vec3d& end, double radius);

// A cylinder between two surfaces orthogonal to it. The circles where it meets them are creases, in short chords.
int add_column(Scene& scene, const Cylinder& cylinder, int surface_at_begin, int surface_at_end);

}  // namespace augicp::testing
