// SPDX-License-Identifier: MIT
#include "augicp/io/depth_png.h"

#include <spng.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "augicp/core/check.h"
#include "augicp/io/atomic_file.h"
#include "augicp/io/format.h"

namespace augicp {
namespace {

constexpr std::uint32_t kMaxSide = 16384;          // pixels; above any depth sensor's
constexpr std::size_t kMaxChunkBytes = 8'388'608;  // of one chunk that is not image data, and of all such

using Context = std::unique_ptr<spng_ctx, void (*)(spng_ctx*)>;

void check(int code, const std::filesystem::path& path) {
  if (code != SPNG_OK) throw io_error(path, fmt::format("expected a whole PNG, found: {}", spng_strerror(code)));
}

std::string kind_of(const spng_ihdr& header) {
  constexpr const char* kColours[] = {"grey", "?", "RGB", "palette", "grey with alpha", "?", "RGB with alpha"};
  return fmt::format("{}-bit {}{}", header.bit_depth, kColours[std::min<int>(header.color_type, 6)],
                     header.interlace_method == SPNG_INTERLACE_NONE ? "" : ", interlaced");
}

spng_ihdr checked_header(spng_ctx* context, const FileBytes& file) {
  // The size is looked at before anything is allocated for it.
  check(spng_set_image_limits(context, kMaxSide, kMaxSide), file.path);
  check(spng_set_chunk_limits(context, kMaxChunkBytes, kMaxChunkBytes), file.path);
  check(spng_set_crc_action(context, SPNG_CRC_ERROR, SPNG_CRC_ERROR), file.path);
  check(spng_set_png_buffer(context, file.bytes.data(), file.bytes.size()), file.path);
  spng_ihdr header{};
  check(spng_get_ihdr(context, &header), file.path);
  if (header.bit_depth != 16 || header.color_type != SPNG_COLOR_TYPE_GRAYSCALE ||
      header.interlace_method != SPNG_INTERLACE_NONE)
    throw io_error(file.path, "expected a depth image of 16-bit grey values, found " + kind_of(header));
  // Deflate makes at most 1032 bytes of one.
  if (std::uint64_t{2} * header.width * header.height / 1032 > file.bytes.size())
    throw io_error(file.path,
                   fmt::format("expected {} x {} pixels, the file is too short for them", header.width, header.height));
  return header;
}

// The decoder does not ask for the whole of the last chunk.
void check_end(const FileBytes& file) {
  constexpr std::string_view kLastChunk("\0\0\0\0IEND\xae\x42\x60\x82", 12);
  if (file.bytes.rfind(kLastChunk) == std::string::npos)
    throw io_error(file.path, "expected a whole PNG, found no end chunk");
}

// Read as no reading, see depth_image().
constexpr std::uint16_t kOutOfRange = 65535;

std::uint16_t grey(float depth, double depth_scale) {
  const double value = std::round(static_cast<double>(depth) * depth_scale);
  return value > 0.0 && value < kOutOfRange ? static_cast<std::uint16_t>(value) : std::uint16_t{0};  // NaN fails
}

}  // namespace

DepthImage parse_depth_png(const FileBytes& file, double depth_scale) {
  require_positive("depth_scale", depth_scale);
  const Context context(spng_ctx_new(0), &spng_ctx_free);
  if (!context) throw std::bad_alloc();
  const spng_ihdr header = checked_header(context.get(), file);
  std::vector<std::uint16_t> values(std::size_t{header.width} * header.height);
  check(spng_decode_image(context.get(), values.data(), values.size() * sizeof(values[0]), SPNG_FMT_PNG, 0), file.path);
  check(spng_decode_chunks(context.get()), file.path);
  check_end(file);
  return depth_image(values, static_cast<int>(header.width), static_cast<int>(header.height), depth_scale);
}

DepthImage read_depth_png(const std::filesystem::path& path, double depth_scale) {
  return parse_depth_png(read_bytes(path), depth_scale);
}

bool tells_depth_scale(const DepthImage& image) {
  constexpr double kMinShare = 0.01;
  const auto count = std::count_if(image.depth.begin(), image.depth.end(), [](float depth) { return !std::isnan(depth); });
  return static_cast<double>(count) > kMinShare * static_cast<double>(image.depth.size());
}

std::optional<std::string> depth_scale_problem(const DepthImage& image, double depth_scale) {
  constexpr float kNearest = 0.05f, kFarthest = 200.0f;  // metres; depth cameras and LiDARs measure between
  std::vector<float> readings;
  std::copy_if(image.depth.begin(), image.depth.end(), std::back_inserter(readings),
               [](float z) { return !std::isnan(z); });
  if (readings.empty()) return std::nullopt;
  const auto middle = readings.begin() + static_cast<std::ptrdiff_t>(readings.size() / 2);
  std::nth_element(readings.begin(), middle, readings.end());
  if (*middle >= kNearest && *middle <= kFarthest) return std::nullopt;
  return fmt::format("the median depth is {} m: is the depth scale {} right? It is a divisor, metres = value / scale; "
                     "5000 for TUM, 1000 for most others",
                     *middle, depth_scale);
}

void check_depth_scale(const DepthImage& image, const std::filesystem::path& path, double depth_scale) {
  if (const auto problem = depth_scale_problem(image, depth_scale)) throw io_error(path, *problem);
}

void write_depth_png(const std::filesystem::path& path, const DepthImage& image, double depth_scale) {
  require_positive("depth_scale", depth_scale);
  require(
      image.width > 0 && image.height > 0 && image.depth.size() == std::size_t(image.width) * std::size_t(image.height),
      "depth image", static_cast<double>(image.depth.size()), "must hold width * height values, and one at least");
  std::vector<std::uint16_t> values;
  values.reserve(image.depth.size());
  for (float depth : image.depth) values.push_back(grey(depth, depth_scale));

  const Context context(spng_ctx_new(SPNG_CTX_ENCODER), &spng_ctx_free);
  if (!context) throw std::bad_alloc();
  spng_ihdr header{};
  header.width = static_cast<std::uint32_t>(image.width);
  header.height = static_cast<std::uint32_t>(image.height);
  header.bit_depth = 16;
  header.color_type = SPNG_COLOR_TYPE_GRAYSCALE;
  check(spng_set_ihdr(context.get(), &header), path);
  check(spng_set_option(context.get(), SPNG_ENCODE_TO_BUFFER, 1), path);
  check(spng_encode_image(context.get(), values.data(), values.size() * sizeof(values[0]), SPNG_FMT_PNG,
                          SPNG_ENCODE_FINALIZE),
        path);
  std::size_t num_bytes = 0;
  int code = SPNG_OK;
  const std::unique_ptr<void, void (*)(void*)> bytes(spng_get_png_buffer(context.get(), &num_bytes, &code), &std::free);
  check(code, path);
  write_file(path, {static_cast<const char*>(bytes.get()), num_bytes});
}

}  // namespace augicp
