// SPDX-License-Identifier: MIT
#include <limits>
#include <vector>

#include "augicp/io/depth_formats.h"
#include "augicp/io/format.h"

namespace augicp {

void check_image_sides(const FileBytes& file, std::uint64_t width, std::uint64_t height) {
  constexpr std::uint64_t kMaxSide = 16384;
  if (width == 0 || height == 0 || width > kMaxSide || height > kMaxSide)
    throw io_error(file.path,
                   fmt::format("expected an image of 1 to {} pixels a side, found {} x {}", kMaxSide, width, height));
}

DepthImage depth_of_values(std::size_t width, std::size_t height, const DepthUnit& unit,
                           const std::function<double(std::size_t, std::size_t)>& value_at) {
  const double no_reading = unit.depth_scale ? 65535.0 : std::numeric_limits<double>::infinity();
  std::vector<float> values(width * height);
  for (std::size_t v = 0; v < height; ++v)
    for (std::size_t u = 0; u < width; ++u) {
      const double value = value_at(v, u);
      values[v * width + u] = value == no_reading ? 0.0f : static_cast<float>(value);
    }
  return depth_image(values, static_cast<int>(width), static_cast<int>(height), unit.depth_scale.value_or(1.0));
}

}  // namespace augicp
