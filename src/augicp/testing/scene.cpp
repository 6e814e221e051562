// SPDX-License-Identifier: MIT
#include "augicp/testing/scene.h"

#include <array>
#include <cmath>
#include <numbers>
#include <optional>

#include "augicp/geometry/rotation.h"

namespace augicp::testing {
namespace {

// Chords of a circular crease: 64 of them stay within 0.12 % of the radius.
constexpr int kNumChords = 64;

Vec3d signs_of(int corner) { return {corner & 1 ? 1.0 : -1.0, corner & 2 ? 1.0 : -1.0, corner & 4 ? 1.0 : -1.0}; }

// The face at -1 or +1 along an axis, as a rectangle spanned along the two other axes.
Rectangle box_face(const Rigid3& world_from_box, const Vec3d& size, int axis, double sign) {
  const int u = (axis + 1) % 3, v = (axis + 2) % 3;
  Vec3d corner = -0.5 * size;
  corner[axis] *= -sign;
  return {world_from_box * corner, world_from_box.rotation * Vec3d(size[u] * Vec3d::Unit(u)),
          world_from_box.rotation * Vec3d(size[v] * Vec3d::Unit(v))};
}

// The twelve pairs of corners that differ along one axis; the faces that meet there are those of the two other axes.
void add_box_creases(Scene& scene, const Rigid3& world_from_box, const Vec3d& size, const std::array<int, 6>& faces) {
  for (int axis = 0; axis < 3; ++axis) {
    const int u = (axis + 1) % 3, v = (axis + 2) % 3;
    for (int corner = 0; corner < 8; ++corner) {
      const Vec3d begin = signs_of(corner);
      if (begin[axis] > 0.0) continue;
      const Vec3d end = begin + 2.0 * Vec3d::Unit(axis);
      scene.creases.push_back({world_from_box * Vec3d(0.5 * begin.cwiseProduct(size)),
                               world_from_box * Vec3d(0.5 * end.cwiseProduct(size)), faces[2 * u + (begin[u] > 0.0)],
                               faces[2 * v + (begin[v] > 0.0)]});
    }
  }
}

BoxFaces add_box_on(Scene& scene, const Rigid3& world_from_box, const Vec3d& size, std::optional<int> ground) {
  constexpr int kBottom = 4;
  std::array<int, 6> faces{};
  for (int face = 0; face < 6; ++face) {
    const bool own = face != kBottom || !ground;
    faces[face] = own ? add_surface(scene, box_face(world_from_box, size, face / 2, face % 2 ? 1.0 : -1.0)) : *ground;
  }
  add_box_creases(scene, world_from_box, size, faces);
  return {faces[0], faces[1], faces[2], faces[3], faces[4], faces[5]};
}

void add_circle(Scene& scene, const Vec3d& center, const Vec3d& axis, double radius, int first, int second) {
  const Vec3d u = axis.unitOrthogonal(), v = axis.cross(u);
  const auto point = [&](int i) {
    const double angle = 2.0 * std::numbers::pi * i / kNumChords;
    return Vec3d(center + radius * (std::cos(angle) * u + std::sin(angle) * v));
  };
  for (int i = 0; i < kNumChords; ++i) scene.creases.push_back({point(i), point(i + 1), first, second});
}

}  // namespace

Rigid3 look_at(const Vec3d& eye, const Vec3d& point) {
  Mat3d axes;  // of the camera, in the world: right, down, forward
  axes.col(2) = (point - eye).normalized();
  axes.col(0) = axes.col(2).cross(Vec3d::UnitZ()).normalized();
  axes.col(1) = axes.col(2).cross(axes.col(0));
  return {Eigen::Quaterniond(axes).normalized(), eye};
}

int add_surface(Scene& scene, const Surface& surface) {
  scene.surfaces.push_back(surface);
  return static_cast<int>(scene.surfaces.size()) - 1;
}

BoxFaces add_box(Scene& scene, const Rigid3& world_from_box, const Vec3d& size) {
  return add_box_on(scene, world_from_box, size, std::nullopt);
}

BoxFaces add_standing_box(Scene& scene, const Vec3d& base, double yaw_rad, const Vec3d& size, int ground) {
  const Rigid3 world_from_box{rotation_exp(Vec3d(0.0, 0.0, yaw_rad)), base + Vec3d(0.0, 0.0, 0.5 * size.z())};
  return add_box_on(scene, world_from_box, size, ground);
}

int add_wire(Scene& scene, const Vec3d& begin, const Vec3d& end, double radius) {
  const int wire = add_surface(scene, Cylinder{begin, end, radius});
  scene.creases.push_back({begin, end, wire, wire});
  return wire;
}

int add_column(Scene& scene, const Cylinder& cylinder, int surface_at_begin, int surface_at_end) {
  const Vec3d axis = (cylinder.end - cylinder.begin).normalized();
  const int column = add_surface(scene, cylinder);
  add_circle(scene, cylinder.begin, axis, cylinder.radius, column, surface_at_begin);
  add_circle(scene, cylinder.end, axis, cylinder.radius, column, surface_at_end);
  return column;
}

}  // namespace augicp::testing
