// SPDX-License-Identifier: MIT
#include "augicp/io/depth_png.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "augicp/core/check.h"
#include "augicp/core/median.h"
#include "augicp/io/atomic_file.h"
#include "augicp/io/format.h"
#include "augicp/io/png.h"

namespace augicp {
namespace {

// Counts as no reading, see depth_image().
constexpr std::uint16_t kOutOfRange = 65535;

std::uint16_t grey(float depth, double depth_scale) {
  const double value = std::round(static_cast<double>(depth) * depth_scale);
  return value > 0.0 && value < kOutOfRange ? static_cast<std::uint16_t>(value) : std::uint16_t{0};  // NaN fails
}

// Nearly all readings of depth cameras are within, metres.
constexpr float kNearest_m = 0.2f, kFarthest_m = 10.0f;
constexpr double kTail = 0.01;

std::vector<float> readings_of(const DepthImage& image) {
  std::vector<float> readings;
  std::copy_if(image.depth.begin(), image.depth.end(), std::back_inserter(readings),
               [](float z) { return !std::isnan(z); });
  return readings;
}

// The nearest and the farthest reading but for a hundredth at each end. REQUIRES: there are readings.
std::pair<float, float> range_of(const DepthImage& image) {
  const std::vector<float> readings = readings_of(image);
  const auto rank = static_cast<std::size_t>(kTail * static_cast<double>(readings.size() - 1));
  return {value_at_rank(readings, rank), value_at_rank(readings, readings.size() - 1 - rank)};
}

}  // namespace

DepthImage parse_depth_png(const FileBytes& file, double depth_scale) {
  require_positive("depth_scale", depth_scale);
  PngReader png(file);
  if (!png.is(16, SPNG_COLOR_TYPE_GRAYSCALE))
    throw io_error(file.path, "expected a depth image of 16-bit grey values, found " + png.kind());
  return depth_image(png.decode<std::uint16_t>(1), png.width(), png.height(), depth_scale);
}

DepthImage read_depth_png(const std::filesystem::path& path, double depth_scale) {
  return parse_depth_png(read_bytes(path), depth_scale);
}

bool tells_depth_scale(const DepthImage& image) {
  constexpr double kMinShare = 0.01;
  const auto count =
      std::count_if(image.depth.begin(), image.depth.end(), [](float depth) { return !std::isnan(depth); });
  return static_cast<double>(count) > kMinShare * static_cast<double>(image.depth.size());
}

std::optional<std::string> depth_scale_problem(const DepthImage& image, double depth_scale) {
  constexpr float kNearest = 0.05f, kFarthest = 200.0f;  // metres; the range of depth cameras and LiDARs
  std::vector<float> readings = readings_of(image);
  if (readings.empty()) return std::nullopt;
  const float middle = upper_median(std::move(readings));
  if (middle >= kNearest && middle <= kFarthest) return std::nullopt;
  return fmt::format(
      "the median depth is {} m: is the depth scale {} right? It is a divisor, metres = value / scale; "
      "5000 for TUM, 1000 for most others; floats are metres already",
      middle, depth_scale);
}

std::optional<std::string> depth_scale_suspicion(const DepthImage& image, double depth_scale) {
  if (!tells_depth_scale(image)) return std::nullopt;
  const auto [near, far] = range_of(image);
  if (near < kNearest_m || far > kFarthest_m)
    return fmt::format(
        "readings are from {:.2g} to {:.3g} m, unusual for a depth camera: is the depth scale {} right? 5000 for TUM, "
        "1000 for most others",
        near, far, depth_scale);
  return std::nullopt;
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

  const PngContext context(spng_ctx_new(SPNG_CTX_ENCODER), &spng_ctx_free);
  if (!context) throw std::bad_alloc();
  spng_ihdr header{};
  header.width = static_cast<std::uint32_t>(image.width);
  header.height = static_cast<std::uint32_t>(image.height);
  header.bit_depth = 16;
  header.color_type = SPNG_COLOR_TYPE_GRAYSCALE;
  check_png(spng_set_ihdr(context.get(), &header), path);
  check_png(spng_set_option(context.get(), SPNG_ENCODE_TO_BUFFER, 1), path);
  check_png(spng_encode_image(context.get(), values.data(), values.size() * sizeof(values[0]), SPNG_FMT_PNG,
                              SPNG_ENCODE_FINALIZE),
            path);
  std::size_t num_bytes = 0;
  int code = SPNG_OK;
  const std::unique_ptr<void, void (*)(void*)> bytes(spng_get_png_buffer(context.get(), &num_bytes, &code), &std::free);
  check_png(code, path);
  write_file(path, {static_cast<const char*>(bytes.get()), num_bytes});
}

}  // namespace augicp
