// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "augicp/cloud/cloud.h"
#include "augicp/cloud/index_image.h"

namespace augicp {

// Brightness of each pixel in [0, 1], row-major; NaN if unknown.
struct GreyImage {
  int width = 0;
  int height = 0;
  std::vector<float> value;

  float at(int u, int v) const { return value[static_cast<std::size_t>(v) * width + u]; }
};

// Throws std::invalid_argument if the array's length is not width * height.
void check_size(const GreyImage& image);

// Gives every point the brightness of its pixel. Throws std::invalid_argument if the sizes of the two images differ.
void add_intensities(Cloud& cloud, const IndexImage& seen, const GreyImage& image);

}  // namespace augicp
