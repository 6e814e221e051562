// SPDX-License-Identifier: MIT
#include "augicp/testing/rendering.h"

#include <cmath>
#include <limits>
#include <random>

#include "augicp/testing/poses.h"

namespace augicp::testing {
namespace {

struct SurfaceHit {
  int surface = Rendering::kNothing;
  Hit hit{std::numeric_limits<double>::infinity(), Vec3d::Zero()};
};

SurfaceHit nearest_hit(const Scene& scene, const Ray& ray) {
  SurfaceHit nearest;
  for (std::size_t i = 0; i < scene.surfaces.size(); ++i) {
    const auto found = intersect(scene.surfaces[i], ray);
    if (found && found->distance < nearest.hit.distance) nearest = {static_cast<int>(i), *found};
  }
  return nearest;
}

}  // namespace

Rendering render(const Scene& scene, const Pinhole& camera, int width, int height, const Rigid3& world_from_camera) {
  const std::size_t num_pixels = static_cast<std::size_t>(width) * height;
  Rendering seen{camera,
                 world_from_camera,
                 {width, height, std::vector<float>(num_pixels, std::nanf(""))},
                 std::vector<int>(num_pixels, Rendering::kNothing),
                 std::vector<Vec3f>(num_pixels, Vec3f::Zero())};
  const Mat3d rotation = world_from_camera.rotation.toRotationMatrix();
  std::size_t pixel = 0;
  for (int v = 0; v < height; ++v) {
    for (int u = 0; u < width; ++u, ++pixel) {
      // One unit forward for one unit of the ray: the distance of a hit is its depth.
      const Vec3d in_camera((u - camera.cx) / camera.fx, (v - camera.cy) / camera.fy, 1.0);
      const SurfaceHit nearest = nearest_hit(scene, {world_from_camera.translation, rotation * in_camera});
      if (nearest.surface == Rendering::kNothing) continue;
      seen.depth.depth[pixel] = static_cast<float>(nearest.hit.distance);
      seen.surface[pixel] = nearest.surface;
      seen.normal[pixel] = (rotation.transpose() * nearest.hit.normal).cast<float>();
    }
  }
  return seen;
}

Rendering render(const Scene& scene, const Pinhole& camera) {
  return render(scene, camera, camera.width, camera.height, scene.world_from_camera);
}

Pinhole kinect_like_camera(int width) {
  const int height = width * 3 / 4;
  const double focal_length = 575.0 * width / 640.0;
  return {focal_length, focal_length, 0.5 * (width - 1), 0.5 * (height - 1), width, height};
}

void add_depth_noise(DepthImage& image, double sigma_at_1m, unsigned seed) {
  std::mt19937 generator(seed);
  for (float& depth : image.depth) depth += static_cast<float>(sigma_at_1m * gaussian(generator)) * depth * depth;
}

void quantise_disparity(DepthImage& image, double step_at_1m) {
  for (float& depth : image.depth)
    depth = static_cast<float>(1.0 / (step_at_1m * std::round(1.0 / (step_at_1m * depth))));
}

}  // namespace augicp::testing
