// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "augicp/cloud/cloud.h"
#include "augicp/cloud/index_image.h"

namespace augicp {

// How bright each pixel is, in [0, 1], row-major; NaN where that is not known.
struct GreyImage {
  int width = 0;
  int height = 0;
  std::vector<float> value;

  float at(int u, int v) const { return value[static_cast<std::size_t>(v) * width + u]; }
};

// Throws std::invalid_argument where the array's length is not width * height.
void check_size(const GreyImage& image);

// Gives every point the brightness of the pixel that it was seen in. Throws std::invalid_argument where the two images
// are not of one size.
void add_intensities(Cloud& cloud, const IndexImage& seen, const GreyImage& image);

}  // namespace augicp
