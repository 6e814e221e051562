// SPDX-License-Identifier: MIT
#include "augicp/sensor/projection.h"

#include <atomic>
#include <bit>
#include <cmath>
#include <limits>
#include <memory>

#include "augicp/core/parallel.h"

namespace augicp {
namespace {

// A z-buffer cell: depth in the upper half, index in the lower. Positive floats order as their bits do, so that the
// smallest key is the nearest point, and among equals the lowest index, in whatever order threads come.
using Key = std::uint64_t;
constexpr Key kEmpty = std::numeric_limits<Key>::max();

Key key_of(float depth, std::uint32_t index) { return static_cast<Key>(std::bit_cast<std::uint32_t>(depth)) << 32 | index; }

void keep_smaller(std::atomic<Key>& cell, Key key) {
  Key present = cell.load(std::memory_order_relaxed);
  while (key < present && !cell.compare_exchange_weak(present, key, std::memory_order_relaxed)) {
  }
}

}  // namespace

IndexImage project(const Cloud& cloud, const Rigid3& camera_from_points, const Pinhole& camera, int width, int height,
                   int num_threads) {
  IndexImage seen(width, height);
  const auto cells = std::make_unique<std::atomic<Key>[]>(seen.index.size());
  for (std::size_t i = 0; i < seen.index.size(); ++i) cells[i].store(kEmpty, std::memory_order_relaxed);
  const Eigen::Matrix3f rotation = camera_from_points.rotation.toRotationMatrix().cast<float>();
  const Vec3f translation = camera_from_points.translation.cast<float>();
  const float fx = static_cast<float>(camera.fx), fy = static_cast<float>(camera.fy);
  const float cx = static_cast<float>(camera.cx), cy = static_cast<float>(camera.cy);
  for_each_block(cloud.size(), num_threads, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const Vec3f q = rotation * cloud.points[i] + translation;
      if (!(q.z() > 0.0f)) continue;
      // Adding a half and flooring rounds to the pixel; written as comparisons first, so that huge values never reach
      // the conversion to int.
      const float u = fx * q.x() / q.z() + cx + 0.5f, v = fy * q.y() / q.z() + cy + 0.5f;
      if (!(u >= 0.0f && v >= 0.0f && u < static_cast<float>(width) && v < static_cast<float>(height))) continue;
      const std::size_t pixel = static_cast<std::size_t>(v) * width + static_cast<std::size_t>(u);
      keep_smaller(cells[pixel], key_of(q.z(), static_cast<std::uint32_t>(i)));
    }
  });
  for (std::size_t i = 0; i < seen.index.size(); ++i) {
    const Key key = cells[i].load(std::memory_order_relaxed);
    if (key != kEmpty) seen.index[i] = static_cast<std::int32_t>(key & 0xffffffffu);
  }
  return seen;
}

}  // namespace augicp
