// SPDX-License-Identifier: MIT
#include "augicp/io/ros_image.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <limits>
#include <stdexcept>
#include <vector>

#include "augicp/io/depth_png.h"
#include "augicp/io/format.h"
#include "augicp/io/rvl.h"

namespace augicp {
namespace {

constexpr std::uint64_t kMaxSide = 16384;
constexpr std::uint32_t kMaxCoefficients = 64;

bool contains(std::string_view text, std::string_view part) { return text.find(part) != std::string_view::npos; }

bool is_of_floats(std::string_view encoding) { return encoding.starts_with("32FC1"); }

void check_sides(const MessageReader& reader, std::uint64_t width, std::uint64_t height) {
  if (width == 0 || height == 0 || width > kMaxSide || height > kMaxSide)
    reader.fail(fmt::format("expected an image of 1 to {} pixels a side, found {} x {}", kMaxSide, width, height));
}

template <typename T>
std::vector<T> pixels_of(std::string_view data, std::uint64_t width, std::uint64_t height, std::uint64_t row_bytes,
                         ByteOrder order) {
  constexpr ScalarType kType = sizeof(T) == 2 ? ScalarType::Uint16 : ScalarType::Float32;
  std::vector<T> values;
  values.reserve(width * height);
  for (std::uint64_t v = 0; v < height; ++v)
    for (std::uint64_t u = 0; u < width; ++u)
      values.push_back(static_cast<T>(read_scalar(data.data() + v * row_bytes + u * sizeof(T), kType, order)));
  return values;
}

DepthImage parse_image(MessageReader& reader, double depth_scale) {
  reader.take_header();
  const std::uint64_t height = reader.take_count(), width = reader.take_count();
  const std::string encoding = reader.take_text();
  const ByteOrder order = reader.take(ScalarType::Uint8) != 0 ? ByteOrder::Big : ByteOrder::Little;
  const std::uint64_t row_bytes = reader.take_count();
  const std::string_view data = reader.take_bytes(reader.take_count());
  check_sides(reader, width, height);
  const bool is_float = is_of_floats(encoding);
  if (!is_depth_encoding(encoding))
    reader.fail(fmt::format("expected 16UC1, mono16 or 32FC1, found {}", in_quotes(encoding)));
  const std::uint64_t least = width * (is_float ? 4 : 2);
  if (row_bytes < least || data.size() < (height - 1) * row_bytes + least)
    reader.fail(fmt::format("expected {} rows of {} bytes, found {} bytes", height, least, data.size()));
  const int columns = static_cast<int>(width), rows = static_cast<int>(height);
  if (is_float) return depth_image(pixels_of<float>(data, width, height, row_bytes, order), columns, rows, 1.0);
  return depth_image(pixels_of<std::uint16_t>(data, width, height, row_bytes, order), columns, rows, depth_scale);
}

float parameter_at(std::string_view head, std::size_t at) {
  return static_cast<float>(read_scalar(head.data() + at, ScalarType::Float32, ByteOrder::Little));
}

DepthImage from_inverse(DepthImage image, std::string_view head) {
  const float a = parameter_at(head, 4), b = parameter_at(head, 8);
  for (float& depth : image.depth) depth = a / (depth - b);
  return depth_image(image.depth, image.width, image.height, 1.0);  // without what is not above 0
}

// Width and height in front.
DepthImage parse_rvl(MessageReader& reader, std::string_view data, double depth_scale) {
  constexpr std::size_t kSizeBytes = 8;
  if (data.size() < kSizeBytes) reader.fail("expected the size of an RVL image, the message ends here");
  const auto side_at = [&](std::size_t at) {
    return static_cast<std::uint64_t>(read_scalar(data.data() + at, ScalarType::Uint32, ByteOrder::Little));
  };
  const std::uint64_t width = side_at(0), height = side_at(4);
  check_sides(reader, width, height);
  // An image with more pixels than this many times its bytes is no depth image: readings have noise.
  constexpr std::uint64_t kAlwaysAllowedPixels = std::uint64_t{16} << 20, kMostPixelsPerByte = 512;  // pixels
  const std::uint64_t most = std::max<std::uint64_t>(kAlwaysAllowedPixels, kMostPixelsPerByte * data.size());
  if (width * height > most)
    reader.fail(fmt::format("expected an image of at most {} pixels, found {} x {}", most, width, height));
  const auto pixels = rvl_pixels(data.substr(kSizeBytes), width * height);
  if (!pixels) reader.fail(fmt::format("expected {} pixels in RVL; they are damaged", width * height));
  return depth_image(*pixels, static_cast<int>(width), static_cast<int>(height), depth_scale);
}

DepthImage parse_compressed(const std::filesystem::path& source, MessageReader& reader, double depth_scale) {
  constexpr std::size_t kHeadBytes = 12;
  constexpr std::string_view kPngMark = "\x89PNG";
  reader.take_header();
  const std::string format = reader.take_text();
  std::string_view data = reader.take_bytes(reader.take_count());
  if (!is_depth_encoding(format)) reader.fail(fmt::format("expected depth, found {}", in_quotes(format)));
  std::string_view head;
  if (contains(format, "compressedDepth") && !data.starts_with(kPngMark)) {
    head = data.substr(0, kHeadBytes);
    data.remove_prefix(std::min(data.size(), kHeadBytes));
  }
  const bool is_png = data.starts_with(kPngMark), is_float = is_of_floats(format);
  if (!is_png && !contains(format, "rvl"))
    reader.fail(fmt::format("expected a PNG as {}, found other bytes; image_transport's republish makes raw images",
                            in_quotes(format)));
  if (is_float && head.empty()) reader.fail("expected the two parameters of inverse depths before the image");
  const double scale = is_float ? 1.0 : depth_scale;
  DepthImage image = is_png ? parse_depth_png({source, std::string(data)}, scale) : parse_rvl(reader, data, scale);
  return is_float ? from_inverse(std::move(image), head) : image;
}

template <std::size_t kCount>
std::array<double, kCount> take_numbers(MessageReader& reader) {
  std::array<double, kCount> numbers{};
  for (double& number : numbers) number = reader.take_double();
  return numbers;
}

Distortion lens_of(const MessageReader& reader, const std::string& model, const std::vector<double>& d) {
  const auto is_zero = [](double number) { return number == 0.0; };
  if (std::all_of(d.begin(), d.end(), is_zero)) return {};
  const bool is_known = model == "plumb_bob" || model == "rational_polynomial";
  if (!is_known || d.size() < 4 ||
      !std::all_of(d.begin() + std::min<std::ptrdiff_t>(5, std::ssize(d)), d.end(), is_zero))
    reader.fail(
        fmt::format("expected a lens of plumb_bob with 5 coefficients, found {} with {}", in_quotes(model), d.size()));
  return {d[0], d[1], d[2], d[3], d.size() > 4 ? d[4] : 0.0};
}

}  // namespace

bool is_depth_encoding(std::string_view encoding) {
  return encoding == "16UC1" || encoding == "mono16" || encoding == "32FC1" || contains(encoding, "compressedDepth") ||
         (encoding.starts_with("16UC1") && contains(encoding, "png"));
}

std::string image_encoding(const std::filesystem::path& source, std::string_view type, std::string_view message,
                           MessageForm form) {
  MessageReader reader(source, type, message, form);
  reader.take_header();
  if (type == kImage) {
    reader.take_count();
    reader.take_count();
  }
  return reader.take_text();
}

DepthImage parse_depth_message(const std::filesystem::path& source, std::string_view type, std::string_view message,
                               MessageForm form, double depth_scale) {
  MessageReader reader(source, type, message, form);
  return type == kImage ? parse_image(reader, depth_scale) : parse_compressed(source, reader, depth_scale);
}

DepthCamera parse_camera_info(const std::filesystem::path& source, std::string_view message, MessageForm form,
                              bool are_rectified) {
  MessageReader reader(source, kCameraInfo, message, form);
  reader.take_header();
  DepthCamera camera;
  const std::uint32_t height = reader.take_count(), width = reader.take_count();
  if (height > kMaxSide || width > kMaxSide) check_sides(reader, width, height);
  const std::string model = reader.take_text();
  const std::uint32_t count = reader.take_count();
  if (count > kMaxCoefficients) reader.fail(fmt::format("expected at most {} coefficients", kMaxCoefficients));
  std::vector<double> d;
  for (std::uint32_t i = 0; i < count; ++i) d.push_back(reader.take_double());
  const auto k = take_numbers<9>(reader);
  take_numbers<9>(reader);  // R, of stereo pairs
  const auto p = take_numbers<12>(reader);
  camera.pinhole = {k[0], k[4], k[2], k[5], static_cast<int>(width), static_cast<int>(height)};
  if (are_rectified && p[0] != 0.0) {
    camera.pinhole.fx = p[0], camera.pinhole.fy = p[5], camera.pinhole.cx = p[2], camera.pinhole.cy = p[6];
  } else {
    camera.distortion = lens_of(reader, model, d);
  }
  try {
    camera.check();
  } catch (const std::invalid_argument& error) {
    reader.fail(error.what());
  }
  return camera;
}

}  // namespace augicp
