// SPDX-License-Identifier: MIT
#include "augicp/testing/edge_truth.h"

#include <algorithm>
#include <cmath>

namespace augicp::testing {
namespace {

// Creases are judged piece by piece, each by its middle.
constexpr double kPieceLength = 0.01;  // metres

struct Window {
  int left, right, top, bottom;  // inclusive; empty where left > right or top > bottom
};

Window window_around(double u, double v, double radius_px, int width, int height) {
  const auto clamped = [](double x, int size) {
    return static_cast<int>(std::clamp(x, -1.0, static_cast<double>(size)));
  };
  return {std::max(0, clamped(std::ceil(u - radius_px), width)),
          std::min(width - 1, clamped(std::floor(u + radius_px), width)),
          std::max(0, clamped(std::ceil(v - radius_px), height)),
          std::min(height - 1, clamped(std::floor(v + radius_px), height))};
}

Vec3d point_seen(const Rendering& seen, int u, int v) {
  const Pinhole& camera = seen.camera;
  return seen.depth.at(u, v) * Vec3d((u - camera.cx) / camera.fx, (v - camera.cy) / camera.fy, 1.0);
}

// Whether pixels of both surfaces show points within radius of this one.
bool both_seen_near(const Rendering& seen, const Crease& crease, const Vec3d& point, double radius) {
  const double nearest_depth = point.z() - radius;
  if (nearest_depth <= 0.0) return false;
  const Pinhole& camera = seen.camera;
  const double u = camera.fx * point.x() / point.z() + camera.cx, v = camera.fy * point.y() / point.z() + camera.cy;
  // Wide enough for the whole ball, also far from the image's centre, where a ball's image is longer.
  const double radius_px = 1.5 * std::max(camera.fx, camera.fy) * radius / nearest_depth + 1.0;
  const Window window = window_around(u, v, radius_px, seen.depth.width, seen.depth.height);
  bool first_seen = false, second_seen = false;
  for (int y = window.top; y <= window.bottom; ++y) {
    for (int x = window.left; x <= window.right; ++x) {
      const int surface = seen.surface[static_cast<std::size_t>(y) * seen.depth.width + x];
      if (surface != crease.first_surface && surface != crease.second_surface) continue;
      if ((point_seen(seen, x, y) - point).squaredNorm() > radius * radius) continue;
      first_seen |= surface == crease.first_surface;
      second_seen |= surface == crease.second_surface;
      if (first_seen && second_seen) return true;
    }
  }
  return false;
}

void add_visible_pieces(const Rendering& seen, const Crease& crease, double radius, std::vector<Crease>& pieces) {
  const Vec3d along = crease.end - crease.begin;
  const int num_pieces = std::max(1, static_cast<int>(std::ceil(along.norm() / kPieceLength)));
  const auto point_at = [&](double piece) { return Vec3d(crease.begin + piece / num_pieces * along); };
  const auto visible = [&](int piece) { return both_seen_near(seen, crease, point_at(piece + 0.5), radius); };
  for (int begin = 0, end = 0; begin < num_pieces; begin = end + 1) {
    for (end = begin; end < num_pieces && visible(end);) ++end;
    if (end == begin) continue;
    pieces.push_back({point_at(begin), point_at(end), crease.first_surface, crease.second_surface});
  }
}

// Whether another surface is seen in the window, across a jump.
bool jumps_within(const Rendering& seen, const Window& window, std::size_t pixel, double jump) {
  for (int y = window.top; y <= window.bottom; ++y)
    for (int x = window.left; x <= window.right; ++x) {
      const std::size_t other = static_cast<std::size_t>(y) * seen.depth.width + x;
      if (seen.surface[other] == seen.surface[pixel]) continue;
      // Written so that a missing depth (NaN) counts as a jump.
      if (!(std::abs(seen.depth.depth[other] - seen.depth.depth[pixel]) <= jump)) return true;
    }
  return false;
}

}  // namespace

std::vector<Crease> visible_creases(const Scene& scene, const Rendering& seen, double radius) {
  const Rigid3 camera_from_world = inverse(seen.world_from_camera);
  std::vector<Crease> pieces;
  for (Crease crease : scene.creases) {
    crease.begin = camera_from_world * crease.begin;
    crease.end = camera_from_world * crease.end;
    add_visible_pieces(seen, crease, radius, pieces);
  }
  return pieces;
}

NearestCrease nearest_crease(const std::vector<Crease>& creases, const Vec3d& point) {
  NearestCrease nearest;
  for (const Crease& crease : creases) {
    const Vec3d along = crease.end - crease.begin;
    const double share = std::clamp(along.dot(point - crease.begin) / along.squaredNorm(), 0.0, 1.0);
    const double distance = (crease.begin + share * along - point).norm();
    if (distance < nearest.distance) nearest = {distance, crease.tangent()};
  }
  return nearest;
}

std::vector<bool> beside_discontinuity(const Rendering& seen, int radius_px, double jump) {
  const int width = seen.depth.width, height = seen.depth.height;
  std::vector<bool> beside(seen.surface.size(), false);
  std::size_t pixel = 0;
  for (int v = 0; v < height; ++v)
    for (int u = 0; u < width; ++u, ++pixel)
      beside[pixel] = jumps_within(seen, window_around(u, v, radius_px, width, height), pixel, jump);
  return beside;
}

}  // namespace augicp::testing
