// SPDX-License-Identifier: MIT
#include "augicp/sensor/projection.h"

#include <memory>

#include "augicp/core/parallel.h"
#include "augicp/core/vectorized.h"

namespace augicp {
namespace {

// The view in float.
struct View {
  float rotation[9];  // row by row
  float translation[3];
  float fx, fy, cx, cy;
  float width, height;
};

View view_of(const Rigid3& camera_from_points, const Pinhole& camera, int width, int height) {
  View view{};
  const Mat3d rotation = camera_from_points.rotation.toRotationMatrix();
  for (int i = 0; i < 9; ++i) view.rotation[i] = static_cast<float>(rotation(i / 3, i % 3));
  for (int i = 0; i < 3; ++i) view.translation[i] = static_cast<float>(camera_from_points.translation[i]);
  view.fx = static_cast<float>(camera.fx), view.fy = static_cast<float>(camera.fy);
  view.cx = static_cast<float>(camera.cx), view.cy = static_cast<float>(camera.cy);
  view.width = static_cast<float>(width), view.height = static_cast<float>(height);
  return view;
}

// The pixel of a point, negative outside the image, and its depth.
struct Projected {
  explicit Projected(std::size_t count)
      : pixel(std::make_unique_for_overwrite<std::int32_t[]>(count)),
        depth(std::make_unique_for_overwrite<float[]>(count)) {}
  std::unique_ptr<std::int32_t[]> pixel;
  std::unique_ptr<float[]> depth;
};

// xyz: three numbers per point.
AUGICP_VECTORIZED void project_block(const float* __restrict xyz, std::size_t count, const View& __restrict view,
                                     std::int32_t* __restrict pixel, float* __restrict depth) {
  const float* const r = view.rotation;
  const float* const t = view.translation;
  const auto width = static_cast<std::int32_t>(view.width);
  for (std::size_t k = 0; k < count; ++k) {
    const float px = xyz[3 * k], py = xyz[3 * k + 1], pz = xyz[3 * k + 2];
    const float x = r[0] * px + r[1] * py + r[2] * pz + t[0];
    const float y = r[3] * px + r[4] * py + r[5] * pz + t[1];
    const float z = r[6] * px + r[7] * py + r[8] * pz + t[2];
    // Adding a half and flooring rounds to the pixel. Comparisons come first, so that huge values never reach the
    // conversion to int.
    const float u = view.fx * x / z + view.cx + 0.5f, v = view.fy * y / z + view.cy + 0.5f;
    const bool inside = (z > 0.0f) & (u >= 0.0f) & (v >= 0.0f) & (u < view.width) & (v < view.height);
    const auto column = static_cast<std::int32_t>(inside ? u : 0.0f),
               row = static_cast<std::int32_t>(inside ? v : -1.0f);
    pixel[k] = row * width + column;
    depth[k] = z;
  }
}

}  // namespace

IndexImage project(const Cloud& cloud, const Rigid3& camera_from_points, const Pinhole& camera, int width, int height,
                   int num_threads) {
  IndexImage seen(width, height);
  const View view = view_of(camera_from_points, camera, width, height);
  static_assert(sizeof(Vec3f) == 3 * sizeof(float));
  const Projected projected(cloud.size());
  const auto project_points = [&](std::size_t begin, std::size_t end) {
    project_block(cloud.points[begin].data(), end - begin, view, &projected.pixel[begin], &projected.depth[begin]);
  };
  for_each_block(cloud.size(), num_threads, project_points, kLightBlockSize);
  // The z-buffer, whose cells are the image: the nearest point wins, and among equals the first. On one thread:
  // exchanging cells between threads without losing a point would take longer.
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    if (projected.pixel[i] < 0) continue;
    std::int32_t& nearest = seen.index[static_cast<std::size_t>(projected.pixel[i])];
    if (nearest == IndexImage::kNone || projected.depth[i] < projected.depth[static_cast<std::size_t>(nearest)])
      nearest = static_cast<std::int32_t>(i);
  }
  return seen;
}

}  // namespace augicp
