// SPDX-License-Identifier: MIT
// The directory of a TIFF file. Source: TIFF Revision 6.0 (Adobe, 1992), and its supplements for Deflate and
// predictors.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "augicp/io/file_bytes.h"
#include "augicp/io/scalar_type.h"

namespace augicp {

enum class TiffCompression { None, Lzw, Deflate, PackBits };
enum class TiffPredictor { None, Horizontal, FloatingPoint };

// One image of one channel, in blocks: tiles, or strips, which are as wide as the image.
struct TiffImage {
  std::size_t width = 0, height = 0, block_width = 0, block_height = 0;
  bool has_tiles = false;
  ScalarType type = ScalarType::Uint16;  // Uint16, Int16, Uint32, Float32 or Float64
  ByteOrder order = ByteOrder::Little;
  TiffCompression compression = TiffCompression::None;
  TiffPredictor predictor = TiffPredictor::None;
  std::vector<std::uint32_t> offsets, num_bytes;  // of each block, row after row; all within the file

  std::size_t blocks_per_row() const { return (width + block_width - 1) / block_width; }
  std::size_t num_blocks() const { return blocks_per_row() * ((height + block_height - 1) / block_height); }

  // Rows that a block has: the last strip ends with the image, a tile never does.
  std::size_t rows_of_block(std::size_t block) const;
};

// Throws IoError for damage, several images in one file, BigTIFF, more channels, 8 bits, and other compressions.
TiffImage parse_tiff_directory(const FileBytes& file);

}  // namespace augicp
