// SPDX-License-Identifier: MIT
#include <algorithm>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "augicp/io/depth_formats.h"
#include "augicp/io/format.h"
#include "augicp/io/tiff_blocks.h"
#include "augicp/io/tiff_directory.h"

namespace augicp {
namespace {

// An image with more pixels than this many times the bytes of its file is no depth image: readings have noise.
constexpr std::uint64_t kAlwaysAllowed = std::uint64_t{32} << 20, kMostPerByte = 1024;

void check_memory(const FileBytes& file, const TiffImage& image) {
  const std::uint64_t pixels = std::uint64_t{image.num_blocks()} * image.block_width * image.block_height,
                      most = std::max<std::uint64_t>(kAlwaysAllowed, kMostPerByte * file.bytes.size());
  if (pixels * num_bytes(image.type) > most)
    throw io_error(file.path, fmt::format("expected an image of at most {} bytes, found {} pixels", most, pixels));
}

std::string block_of(const FileBytes& file, const TiffImage& image, std::size_t block) {
  const std::size_t size = image.rows_of_block(block) * image.block_width * num_bytes(image.type);
  const std::string_view stored = std::string_view(file.bytes).substr(image.offsets[block], image.num_bytes[block]);
  auto rows = decompressed_block(image.compression, stored, size);
  if (!rows)
    throw io_error_at_byte(file.path, image.offsets[block],
                           fmt::format("expected {} bytes in strip or tile {}; it is damaged", size, block));
  undo_predictor(image, *rows);
  return std::move(*rows);
}

}  // namespace

DepthImage parse_depth_tiff(const FileBytes& file, double depth_scale) {
  const TiffImage image = parse_tiff_directory(file);
  check_memory(file, image);
  const bool is_sorted = image.predictor == TiffPredictor::FloatingPoint;
  const ByteOrder order = is_sorted ? ByteOrder::Big : image.order;
  const std::size_t size = num_bytes(image.type), per_row = image.blocks_per_row();
  std::vector<std::string> blocks(per_row);
  return depth_of_values(image.width, image.height, is_floating(image.type) ? DepthUnit{} : DepthUnit{depth_scale},
                         [&](std::size_t v, std::size_t u) {
                           const std::size_t first_row = v / image.block_height;
                           if (u == 0 && v % image.block_height == 0)
                             for (std::size_t i = 0; i < per_row; ++i)
                               blocks[i] = block_of(file, image, first_row * per_row + i);
                           const std::size_t place = v % image.block_height * image.block_width + u % image.block_width;
                           return read_scalar(blocks[u / image.block_width].data() + place * size, image.type, order);
                         });
}

}  // namespace augicp
