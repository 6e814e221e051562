// SPDX-License-Identifier: MIT
#include "augicp/io/depth_png.h"

#include <cmath>

#include "fuzz/promises.h"

using namespace augicp;
using fuzz::expect;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const FileBytes file = fuzz::file_of("any.png", data, size);
  fuzz::expect_read_or_refused(file.path, [&] {
    const DepthImage image = parse_depth_png(file, 5000.0);
    expect(image.width > 0 && image.height > 0, "an image has a size");
    expect(image.depth.size() == std::size_t(image.width) * std::size_t(image.height), "a reading a pixel");
    for (const float depth : image.depth)
      expect(std::isnan(depth) || (depth > 0.0f && depth < 65535.0f / 5000.0f), "a reading is in range or none");
    check_depth_scale(image, file.path, 5000.0);
  });
  return 0;
}
