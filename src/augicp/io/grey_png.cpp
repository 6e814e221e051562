// SPDX-License-Identifier: MIT
#include "augicp/io/grey_png.h"

#include "augicp/io/format.h"
#include "augicp/io/png.h"

namespace augicp {
namespace {

constexpr int kBits = 8;
constexpr double kLargest = 255.0;

// 0: unsupported.
std::size_t num_channels(const PngReader& png) {
  if (png.is(kBits, SPNG_COLOR_TYPE_GRAYSCALE)) return 1;
  if (png.is(kBits, SPNG_COLOR_TYPE_TRUECOLOR)) return 3;
  if (png.is(kBits, SPNG_COLOR_TYPE_TRUECOLOR_ALPHA)) return 4;
  return 0;
}

double luma(const std::uint8_t* pixel) { return 0.299 * pixel[0] + 0.587 * pixel[1] + 0.114 * pixel[2]; }

}  // namespace

GreyImage parse_grey_png(const FileBytes& file) {
  PngReader png(file);
  const std::size_t channels = num_channels(png);
  if (channels == 0)
    throw io_error(file.path, "expected an image of 8-bit grey, RGB or RGBA values, found " + png.kind());
  const auto values = png.decode<std::uint8_t>(channels);
  GreyImage image{png.width(), png.height(), {}};
  image.value.reserve(values.size() / channels);
  for (std::size_t at = 0; at < values.size(); at += channels)
    image.value.push_back(static_cast<float>((channels == 1 ? values[at] : luma(&values[at])) / kLargest));
  return image;
}

GreyImage read_grey_png(const std::filesystem::path& path) { return parse_grey_png(read_bytes(path)); }

}  // namespace augicp
