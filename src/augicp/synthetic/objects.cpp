// SPDX-License-Identifier: MIT
#include "augicp/synthetic/objects.h"

#include <cmath>
#include <numbers>

#include "augicp/experiment/random.h"

namespace augicp::synthetic {
namespace {

constexpr double kTwoPi = 2.0 * std::numbers::pi;

Patch rectangle(const Vec3d& corner, const Vec3d& side_u, const Vec3d& side_v) {
  const Vec3d across = side_u.cross(side_v);
  return {across.norm(), [=](double u, double v) -> SurfacePoint {
            return {corner + u * side_u + v * side_v, across.normalized()};
          }};
}

void add_box(Object& object, const Vec3d& low, const Vec3d& high) {
  const Vec3d size = high - low;
  for (int axis = 0; axis < 3; ++axis) {
    const Vec3d u = size[(axis + 1) % 3] * Vec3d::Unit((axis + 1) % 3),
                v = size[(axis + 2) % 3] * Vec3d::Unit((axis + 2) % 3);
    object.patches.push_back(rectangle(low + size[axis] * Vec3d::Unit(axis), u, v));
    object.patches.push_back(rectangle(low, v, u));
  }
}

Vec3d on_circle(double angle) { return {std::cos(angle), std::sin(angle), 0.0}; }

// The curved surface of an upright cylinder; sign -1: seen from inside.
void add_tube(Object& object, const Vec3d& foot, double radius, double height, double sign = 1.0) {
  object.patches.push_back({kTwoPi * radius * height, [=](double u, double v) -> SurfacePoint {
                              const Vec3d out = on_circle(kTwoPi * u);
                              return {foot + radius * out + v * height * Vec3d::UnitZ(), sign * out};
                            }});
}

// A level ring between two radii; sign: up or down.
void add_ring(Object& object, const Vec3d& centre, double inner, double outer, double sign = 1.0) {
  const double inner_sq = inner * inner, span = outer * outer - inner_sq;
  object.patches.push_back(
      {std::numbers::pi * span, [=](double u, double v) -> SurfacePoint {
         return {centre + std::sqrt(inner_sq + v * span) * on_circle(kTwoPi * u), sign * Vec3d::UnitZ()};
       }});
}

// A closed upright cylinder.
void add_drum(Object& object, const Vec3d& foot, double radius, double height) {
  add_tube(object, foot, radius, height);
  add_ring(object, foot, 0.0, radius, -1.0);
  add_ring(object, foot + height * Vec3d::UnitZ(), 0.0, radius);
}

void add_sphere(Object& object, const Vec3d& centre, double radius) {
  object.patches.push_back({2.0 * kTwoPi * radius * radius, [=](double u, double v) -> SurfacePoint {
                              const double z = 2.0 * v - 1.0;
                              const Vec3d out = std::sqrt(1.0 - z * z) * on_circle(kTwoPi * u) + z * Vec3d::UnitZ();
                              return {centre + radius * out, out};
                            }});
}

// Half a torus in the x-z plane that opens towards -x. Uniform by area to a quarter of thickness / bend, which is
// enough for a handle.
void add_handle(Object& object, const Vec3d& centre, double bend, double thickness) {
  object.patches.push_back({0.5 * kTwoPi * bend * kTwoPi * thickness, [=](double u, double v) -> SurfacePoint {
                              const double along = std::numbers::pi * (u - 0.5), around = kTwoPi * v;
                              const Vec3d radial(std::cos(along), 0.0, std::sin(along));
                              const Vec3d out = std::cos(around) * radial + std::sin(around) * Vec3d::UnitY();
                              return {centre + bend * radial + thickness * out, out};
                            }});
}

Object chair() {
  Object object{"chair", {}, true, false};
  for (const double x : {-0.2, 0.2})
    for (const double y : {-0.2, 0.2}) add_box(object, {x - 0.02, y - 0.02, -0.45}, {x + 0.02, y + 0.02, 0.0});
  add_box(object, {-0.23, -0.23, 0.0}, {0.23, 0.23, 0.04});
  add_box(object, {-0.23, 0.2, 0.04}, {0.23, 0.23, 0.5});
  return object;
}

Object table() {
  Object object{"table", {}, false, false};
  for (const double x : {-0.5, 0.5})
    for (const double y : {-0.3, 0.3}) add_box(object, {x - 0.03, y - 0.03, -0.4}, {x + 0.03, y + 0.03, 0.3});
  add_box(object, {-0.55, -0.35, 0.3}, {0.55, 0.35, 0.34});
  return object;
}

Object stool() {
  Object object{"stool", {}, false, false};
  add_drum(object, {0.0, 0.0, 0.2}, 0.18, 0.04);
  for (int leg = 0; leg < 3; ++leg) {
    const Vec3d foot = 0.14 * on_circle(kTwoPi * leg / 3.0) - 0.25 * Vec3d::UnitZ();
    add_drum(object, foot, 0.018, 0.45);
  }
  return object;
}

Object mug() {
  Object object{"mug", {}, true, false};
  add_tube(object, {0.0, 0.0, -0.2}, 0.15, 0.4);
  add_tube(object, {0.0, 0.0, -0.18}, 0.14, 0.38, -1.0);
  add_ring(object, {0.0, 0.0, 0.2}, 0.14, 0.15);
  add_ring(object, {0.0, 0.0, -0.2}, 0.0, 0.15, -1.0);
  add_ring(object, {0.0, 0.0, -0.18}, 0.0, 0.14);
  add_handle(object, {0.15, 0.0, 0.0}, 0.11, 0.018);
  return object;
}

Object flange() {
  Object object{"flange", {}, false, false};
  add_tube(object, {0.0, 0.0, -0.03}, 0.3, 0.06);
  add_tube(object, {0.0, 0.0, -0.03}, 0.1, 0.36, -1.0);
  add_ring(object, {0.0, 0.0, -0.03}, 0.1, 0.3, -1.0);
  add_ring(object, {0.0, 0.0, 0.03}, 0.14, 0.3);
  add_tube(object, {0.0, 0.0, 0.03}, 0.14, 0.3);
  add_ring(object, {0.0, 0.0, 0.33}, 0.1, 0.14);
  for (int bolt = 0; bolt < 6; ++bolt)
    add_drum(object, 0.22 * on_circle(kTwoPi * bolt / 6.0) + 0.03 * Vec3d::UnitZ(), 0.03, 0.04);
  return object;
}

Object box() {
  Object object{"box", {}, false, false};
  add_box(object, {-0.15, -0.1, -0.04}, {0.15, 0.1, 0.04});
  return object;
}

Object brick() {
  Object object{"brick", {}, false, false};
  add_box(object, {-0.24, -0.115, -0.071}, {0.24, 0.115, 0.071});
  return object;
}

Object bracket() {
  Object object{"bracket", {}, true, true};
  add_box(object, {-0.2, -0.1, -0.03}, {0.2, 0.1, 0.0});
  add_box(object, {-0.2, -0.1, 0.0}, {-0.17, 0.02, 0.3});
  add_drum(object, {0.12, 0.05, 0.0}, 0.03, 0.1);
  return object;
}

Object hammer() {
  Object object{"hammer", {}, true, false};
  add_drum(object, {0.0, 0.0, -0.3}, 0.02, 0.5);
  add_box(object, {-0.12, -0.04, 0.2}, {0.06, 0.04, 0.28});
  add_box(object, {0.06, -0.03, 0.23}, {0.14, 0.03, 0.25});
  return object;
}

Object lamp() {
  Object object{"lamp", {}, true, true};
  add_drum(object, {0.0, 0.0, -0.3}, 0.14, 0.04);
  add_drum(object, {0.03, 0.04, -0.26}, 0.015, 0.5);
  add_box(object, {0.02, 0.03, 0.24}, {0.3, 0.05, 0.26});
  add_drum(object, {0.28, -0.01, 0.12}, 0.07, 0.12);
  return object;
}

// Overlapping balls: a body, a head, two unlike ears, a tail. Inner parts stay, as in a scan of nested shells.
Object blob() {
  Object object{"blob", {}, true, true};
  add_sphere(object, {0.0, 0.0, -0.05}, 0.2);
  add_sphere(object, {0.15, 0.02, 0.18}, 0.11);
  add_sphere(object, {0.13, 0.08, 0.31}, 0.05);
  add_sphere(object, {0.1, -0.05, 0.29}, 0.04);
  add_sphere(object, {-0.2, 0.05, -0.12}, 0.06);
  return object;
}

SurfacePoint drawn(const Object& object, std::mt19937& generator) {
  double left = uniform(generator, 0.0, object.area());
  const double u = uniform(generator, 0.0, 1.0), v = uniform(generator, 0.0, 1.0);
  std::size_t k = 0;
  for (; k + 1 < object.patches.size() && left > object.patches[k].area; ++k) left -= object.patches[k].area;
  return object.patches[k].at(u, v);
}

Vec3f with_noise(const Vec3d& place, double noise, std::mt19937& generator) {
  const double x = gaussian(generator), y = gaussian(generator), z = gaussian(generator);
  return (place + noise * Vec3d(x, y, z)).cast<float>();
}

}  // namespace

double Object::area() const {
  double sum = 0.0;
  for (const Patch& patch : patches) sum += patch.area;
  return sum;
}

std::vector<Object> objects() {
  return {chair(), table(), stool(), mug(), flange(), box(), brick(), bracket(), hammer(), lamp(), blob()};
}

Cloud sampled(const Object& object, std::size_t count, double noise, std::mt19937& generator) {
  Cloud cloud;
  for (std::size_t i = 0; i < count; ++i)
    cloud.points.push_back(with_noise(drawn(object, generator).place, noise, generator));
  return cloud;
}

Cloud sampled_side(const Object& object, std::size_t count, double noise, const Vec3d& towards_viewer, double distance,
                   std::mt19937& generator) {
  Cloud cloud;
  cloud.viewpoint = (distance * towards_viewer).cast<float>();
  while (cloud.size() < count) {
    const SurfacePoint point = drawn(object, generator);
    if (point.outward.dot(distance * towards_viewer - point.place) > 0.0)
      cloud.points.push_back(with_noise(point.place, noise, generator));
  }
  return cloud;
}

}  // namespace augicp::synthetic
