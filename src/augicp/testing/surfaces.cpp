// SPDX-License-Identifier: MIT
#include "augicp/testing/surfaces.h"

#include <Eigen/Geometry>
#include <cmath>

namespace augicp::testing {
namespace {

// Nearer hits are the ray's own origin, not something in front of it.
constexpr double kMinDistance = 1e-9;

Hit facing(const Ray& ray, double distance, const Vec3d& normal) {
  return {distance, normal.dot(ray.direction) > 0.0 ? Vec3d(-normal) : normal};
}

// The solutions of a t^2 + 2 b t + c = 0, smaller first.
struct Roots {
  double first;
  double second;
};

std::optional<Roots> solve_quadratic(double a, double b, double c) {
  const double discriminant = b * b - a * c;
  if (discriminant < 0.0 || a == 0.0) return std::nullopt;
  const double root = std::sqrt(discriminant);
  return Roots{(-b - root) / a, (-b + root) / a};
}

std::optional<Hit> hit(const Plane& plane, const Ray& ray) {
  const double slope = plane.normal.dot(ray.direction);
  if (slope == 0.0) return std::nullopt;
  const double distance = plane.normal.dot(plane.point - ray.origin) / slope;
  if (!(distance > kMinDistance)) return std::nullopt;
  return facing(ray, distance, plane.normal);
}

// Whether a place lies between 0 and the side's length along it. A hair's breadth more, so that no ray slips through
// where two patches meet.
bool is_along(const Vec3d& side, const Vec3d& from_corner) {
  constexpr double kSlack = 1e-12;
  const double length_sq = side.squaredNorm(), along = from_corner.dot(side);
  return along >= -kSlack * length_sq && along <= (1.0 + kSlack) * length_sq;
}

std::optional<Hit> hit(const Rectangle& patch, const Ray& ray) {
  const double slope = patch.across.dot(ray.direction), ahead = patch.across.dot(patch.corner - ray.origin);
  if (slope == 0.0 || (slope < 0.0) != (ahead < 0.0)) return std::nullopt;
  const double distance = ahead / slope;
  if (!(distance > kMinDistance)) return std::nullopt;
  const Vec3d from_corner = ray.origin + distance * ray.direction - patch.corner;
  if (!is_along(patch.side_u, from_corner) || !is_along(patch.side_v, from_corner)) return std::nullopt;
  return facing(ray, distance, patch.across.normalized());
}

std::optional<Hit> hit(const Sphere& sphere, const Ray& ray) {
  const Vec3d from_center = ray.origin - sphere.center;
  const auto roots = solve_quadratic(ray.direction.squaredNorm(), from_center.dot(ray.direction),
                                     from_center.squaredNorm() - sphere.radius * sphere.radius);
  if (!roots) return std::nullopt;
  for (double distance : {roots->first, roots->second})
    if (distance > kMinDistance) return facing(ray, distance, (from_center + distance * ray.direction) / sphere.radius);
  return std::nullopt;
}

std::optional<Hit> hit(const Cylinder& cylinder, const Ray& ray) {
  const double length = (cylinder.end - cylinder.begin).norm();
  const Vec3d axis = (cylinder.end - cylinder.begin) / length;
  const Vec3d from_begin = ray.origin - cylinder.begin;
  const Vec3d across_origin = from_begin - axis.dot(from_begin) * axis;
  const Vec3d across_direction = ray.direction - axis.dot(ray.direction) * axis;
  const auto roots = solve_quadratic(across_direction.squaredNorm(), across_origin.dot(across_direction),
                                     across_origin.squaredNorm() - cylinder.radius * cylinder.radius);
  if (!roots) return std::nullopt;
  for (double distance : {roots->first, roots->second}) {
    const double along = axis.dot(from_begin + distance * ray.direction);
    if (distance > kMinDistance && along >= 0.0 && along <= length)
      return facing(ray, distance, (across_origin + distance * across_direction) / cylinder.radius);
  }
  return std::nullopt;
}

}  // namespace

std::optional<Hit> intersect(const Surface& surface, const Ray& ray) {
  return std::visit([&](const auto& shape) { return hit(shape, ray); }, surface);
}

}  // namespace augicp::testing
