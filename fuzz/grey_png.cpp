// SPDX-License-Identifier: MIT
#include "augicp/io/grey_png.h"

#include "fuzz/promises.h"

using namespace augicp;
using fuzz::expect;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const FileBytes file = fuzz::file_of("any.png", data, size);
  fuzz::expect_read_or_refused(file.path, [&] {
    const GreyImage image = parse_grey_png(file);
    expect(image.width > 0 && image.height > 0, "an image has a size");
    expect(image.value.size() == std::size_t(image.width) * std::size_t(image.height), "a value a pixel");
    for (const float value : image.value) expect(value >= 0.0f && value <= 1.0f, "brightness from 0 to 1");
  });
  return 0;
}
