// SPDX-License-Identifier: MIT
#include "augicp/io/depth_file.h"

#include <algorithm>
#include <iterator>
#include <string_view>

#include "augicp/core/check.h"
#include "augicp/io/depth_formats.h"
#include "augicp/io/format.h"
#include "augicp/io/npy_header.h"

namespace augicp {
namespace {

// The value in row v and column u.
double value_at(const FileBytes& file, const NpyHeader& header, std::size_t v, std::size_t u) {
  const std::size_t place = header.is_fortran ? u * header.shape[0] + v : v * header.shape[1] + u;
  const char* const bytes = file.bytes.data() + header.body_offset + place * header.item_bytes;
  if (!header.is_half) return read_scalar(bytes, header.type, header.order);
  return static_cast<double>(
      number_of_half(static_cast<std::uint16_t>(read_scalar(bytes, ScalarType::Uint16, header.order))));
}

DepthImage parse_npy_depth(const FileBytes& file, double depth_scale) {
  const NpyHeader header = parse_npy_image_header(file);
  const std::size_t height = header.shape[0], width = header.shape[1];
  check_image_sides(file, width, height);
  if (file.bytes.size() - header.body_offset != width * height * header.item_bytes)
    throw io_error_at_byte(
        file.path, file.bytes.size(),
        fmt::format("expected {} values, found {} bytes", width * height, file.bytes.size() - header.body_offset));
  return depth_of_values(width, height, is_floating(header.type) ? DepthUnit{} : DepthUnit{depth_scale},
                         [&](std::size_t v, std::size_t u) { return value_at(file, header, v, u); });
}

[[noreturn]] DepthImage refuse_exr(const FileBytes& file, double) {
  throw io_error(file.path, "expected depth as .png, .pgm, .pfm, .tif or .npy, found EXR; oiiotool IN.exr -o OUT.tif");
}

[[noreturn]] DepthImage refuse_jpg(const FileBytes& file, double) {
  throw io_error(file.path, "expected depth as .png, .pgm, .pfm, .tif or .npy, found JPEG, which has lost its depths");
}

struct DepthFormat {
  std::string_view extension;
  DepthImage (*parse)(const FileBytes&, double depth_scale);
};

// The last ones are formats that people have, refused with a way around.
constexpr DepthFormat kFormats[] = {{".png", parse_depth_png},  {".pgm", parse_depth_pgm},   {".pfm", parse_depth_pfm},
                                    {".tif", parse_depth_tiff}, {".tiff", parse_depth_tiff}, {".npy", parse_npy_depth},
                                    {".exr", refuse_exr},       {".jpg", refuse_jpg},        {".jpeg", refuse_jpg}};

}  // namespace

bool is_image_file(const std::filesystem::path& path) {
  const std::string extension = lower_case_extension(path);
  return std::any_of(std::begin(kFormats), std::end(kFormats),
                     [&](const DepthFormat& format) { return format.extension == extension && extension != ".npy"; });
}

DepthImage parse_depth_image(const FileBytes& file, double depth_scale) {
  require_positive("depth_scale", depth_scale);
  const std::string extension = lower_case_extension(file.path);
  for (const DepthFormat& format : kFormats)
    if (format.extension == extension) return format.parse(file, depth_scale);
  return parse_depth_png(file, depth_scale);  // whose mark shows that it is none
}

DepthImage read_depth_image(const std::filesystem::path& path, double depth_scale) {
  require_positive("depth_scale", depth_scale);
  return parse_depth_image(read_bytes(path), depth_scale);
}

}  // namespace augicp
