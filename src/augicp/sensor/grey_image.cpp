// SPDX-License-Identifier: MIT
#include "augicp/sensor/grey_image.h"

#include <limits>
#include <stdexcept>
#include <string>

namespace augicp {

void check_size(const GreyImage& image) {
  if (image.width < 0 || image.height < 0 || image.value.size() != static_cast<std::size_t>(image.width) * image.height)
    throw std::invalid_argument("grey image: the array does not hold width * height values");
}

void add_intensities(Cloud& cloud, const IndexImage& seen, const GreyImage& image) {
  check_size(image);
  if (seen.width != image.width || seen.height != image.height)
    throw std::invalid_argument("grey image is " + std::to_string(image.width) + " x " + std::to_string(image.height) +
                                " pixels, the depth image " + std::to_string(seen.width) + " x " +
                                std::to_string(seen.height));
  cloud.intensities.assign(cloud.size(), std::numeric_limits<float>::quiet_NaN());
  for (std::size_t pixel = 0; pixel < seen.index.size(); ++pixel)
    if (seen.index[pixel] != IndexImage::kNone) cloud.intensities[seen.index[pixel]] = image.value[pixel];
}

}  // namespace augicp
