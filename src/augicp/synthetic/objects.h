// SPDX-License-Identifier: MIT
// Generated objects of everyday shapes, and clouds of points on them.
#pragma once

#include <functional>
#include <random>
#include <string>
#include <vector>

#include "augicp/cloud/cloud.h"

namespace augicp::synthetic {

// A point on an object's surface; metres, the object's frame.
struct SurfacePoint {
  Vec3d place;
  Vec3d outward;  // unit normal
};

// A part of a surface, parametrised so that (u, v) uniform in the unit square is uniform by area.
struct Patch {
  double area = 0.0;  // m^2
  std::function<SurfacePoint(double u, double v)> at;
};

// About 0.3 to 1 m in size, about its frame's zero, upright along z.
struct Object {
  std::string name;
  std::vector<Patch> patches;

  // Whether no rotation but the identity, and whether no reflection either, maps it to itself.
  bool is_unique = true;
  bool is_chiral = false;

  double area() const;
};

// A chair, a table, a three-legged stool, a mug, a flange with bolts, a box, a brick, an L-shaped bracket, a hammer, a
// desk lamp, and a smooth blob with ears. All six motions of each are observed.
std::vector<Object> objects();

// `count` points uniform by area, each moved by normal noise of this standard deviation along every axis, metres.
Cloud sampled(const Object& object, std::size_t count, double noise, std::mt19937& generator);

// The same of what faces a viewer in this direction (unit), about half of the object; the cloud's viewpoint is there,
// `distance` metres from the object's zero. Self-occlusion is left out.
Cloud sampled_side(const Object& object, std::size_t count, double noise, const Vec3d& towards_viewer, double distance,
                   std::mt19937& generator);

}  // namespace augicp::synthetic
