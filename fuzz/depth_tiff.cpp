// SPDX-License-Identifier: MIT
#include "augicp/io/depth_file.h"
#include "fuzz/promises.h"

using namespace augicp;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const FileBytes file = fuzz::file_of("any.tif", data, size);
  fuzz::expect_read_or_refused(file.path, [&] {
    const DepthImage image = parse_depth_image(file, 1000.0);
    fuzz::expect(image.width > 0 && image.height > 0, "an image has pixels");
    fuzz::expect(image.depth.size() == std::size_t(image.width) * std::size_t(image.height), "a depth a pixel");
  });
  return 0;
}
