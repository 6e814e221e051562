// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace augicp {

// An image of indices into a cloud, row-major: the point that each pixel sees. Also the grid of an organised file.
struct IndexImage {
  static constexpr std::int32_t kNone = -1;

  int width = 0;
  int height = 0;
  std::vector<std::int32_t> index;  // width * height entries; kNone if the pixel sees no point

  IndexImage() = default;
  IndexImage(int width_px, int height_px)
      : width(width_px), height(height_px), index(static_cast<std::size_t>(width_px) * height_px, kNone) {}
  std::int32_t at(int u, int v) const { return index[static_cast<std::size_t>(v) * width + u]; }
};

}  // namespace augicp
