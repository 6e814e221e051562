// SPDX-License-Identifier: MIT
// The first byte chooses the form and the type: an image, a compressed one, or a camera.
#include <cmath>

#include "augicp/io/ros_image.h"
#include "fuzz/promises.h"

using namespace augicp;

namespace {

void expect_sound_image(const DepthImage& image) {
  fuzz::expect(image.depth.size() == static_cast<std::size_t>(image.width) * image.height, "a reading for each pixel");
  for (const float depth : image.depth)
    fuzz::expect(std::isnan(depth) || (std::isfinite(depth) && depth > 0.0f), "readings are finite and positive");
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  const FileBytes message = fuzz::file_of("any", data + 1, size - 1);
  const MessageForm form = data[0] % 2 == 0 ? MessageForm::Cdr : MessageForm::Ros1;
  const int kind = data[0] / 2 % 3;
  fuzz::expect_read_or_refused(message.path, [&] {
    if (kind == 2) {
      parse_camera_info(message.path, message.bytes, form, data[0] >= 128).check();
    } else {
      const char* type = kind == 0 ? kImage : kCompressedImage;
      image_encoding(message.path, type, message.bytes, form);
      expect_sound_image(parse_depth_message(message.path, type, message.bytes, form, 1000.0));
    }
  });
  return 0;
}
