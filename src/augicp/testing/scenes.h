// SPDX-License-Identifier: MIT
// Scenes for rendering, each with its true creases and a camera 1 to 3 m away from its main objects. World: z up,
// metres.
#pragma once

#include "augicp/testing/scene.h"

namespace augicp::testing {

// A rotated box on a table top; nothing behind the table.
Scene box_on_table();

// A floor and two walls.
Scene room_corner();

// A closed room with boxes, two columns, a pipe and a table; sizes and places are drawn from the seed. At least 4.4 x 3
// x 2.4 m, or the furniture would touch.
Scene room(unsigned seed = 1, const Vec3d& size = {5.0, 4.0, 2.6});

// Two wires with a radius of 5 mm, 1 m in front of the camera: an upright one 1 m before a wall, and a slanting one
// with nothing behind it.
Scene wire();

// A board that floats 0.4 m before a wall: depth jumps all around it, and there is no crease.
Scene depth_step();

// A wall that fills the view, seen askew: three of the six motions are free.
Scene single_plane();

// Two parallel walls side by side, one 0.5 m nearer than the other: a jump, no crease, three free motions.
Scene two_parallel_planes();

// Walls, floor and ceiling that continue beyond the view: the translation along them is free.
Scene corridor();

// A sphere with a radius of 0.5 m: all rotations about its centre are free.
Scene sphere_scene();

// An upright cylinder with a radius of 0.3 m that continues beyond the view: the rotation about it and the translation
// along it are free.
Scene cylinder_scene();

}  // namespace augicp::testing
