// SPDX-License-Identifier: MIT
#include "augicp/io/tiff_directory.h"

#include <algorithm>
#include <string_view>

#include "augicp/io/format.h"

namespace augicp {
namespace {

constexpr std::uint64_t kMaxSide = 16384;
constexpr std::size_t kEntry = 12;  // bytes

// ---- Tags and their values, by the numbers of the specification.

enum Tag : std::uint16_t {
  kWidth = 256,
  kHeight = 257,
  kBits = 258,
  kCompressionTag = 259,
  kFillOrder = 266,
  kStripOffsets = 273,
  kChannels = 277,
  kRowsPerStrip = 278,
  kStripBytes = 279,
  kPredictorTag = 317,
  kTileWidth = 322,
  kTileHeight = 323,
  kTileOffsets = 324,
  kTileBytes = 325,
  kSampleFormat = 339,
};

std::size_t bytes_of_type(std::uint64_t type) {
  return type == 1 ? 1 : type == 3 ? 2 : type == 4 ? 4 : 0;  // BYTE, SHORT, LONG; no tag above has another
}

class Directory {
 public:
  explicit Directory(const FileBytes& file) : file_(file) {
    const std::string_view bytes = file.bytes;
    if (bytes.starts_with("MM")) order_ = ByteOrder::Big;
    if (bytes.size() < 8 || (!bytes.starts_with("II") && !bytes.starts_with("MM")))
      throw io_error_at_byte(file.path, 0, "expected 'II' or 'MM', the mark of a TIFF file");
    const std::uint64_t version = number_at(2, 2);
    if (version == 43) throw io_error(file.path, "is a BigTIFF file, expected a plain one; tiffcp IN OUT makes one");
    if (version != 42) throw io_error_at_byte(file.path, 2, fmt::format("expected 42, found {}", version));
    begin_ = number_at(4, 4);
    count_ = number_at(begin_, 2);
    if (number_at(begin_ + 2 + kEntry * count_, 4) != 0)
      throw io_error(file.path, "has several images, expected one; tiffsplit takes them apart");
  }

  ByteOrder order() const { return order_; }

  // The numbers of a tag; empty if the file lacks it.
  std::vector<std::uint32_t> numbers(Tag tag) const {
    for (std::uint64_t i = 0; i < count_; ++i) {
      const std::uint64_t at = begin_ + 2 + kEntry * i;
      if (number_at(at, 2) == tag) return numbers_at(at);
    }
    return {};
  }

  std::uint64_t number(Tag tag, std::uint64_t otherwise) const {
    const std::vector<std::uint32_t> found = numbers(tag);
    return found.empty() ? otherwise : found.front();
  }

  [[noreturn]] void fail(const std::string& what) const { throw io_error(file_.path, what); }

 private:
  std::uint64_t number_at(std::uint64_t at, std::size_t size) const {
    const std::uint64_t end = file_.bytes.size();
    if (at > end || size > end - at)
      throw io_error_at_byte(file_.path, end, fmt::format("expected {} bytes at {}, the file ends here", size, at));
    const ScalarType type = size == 1 ? ScalarType::Uint8 : size == 2 ? ScalarType::Uint16 : ScalarType::Uint32;
    return static_cast<std::uint64_t>(read_scalar(file_.bytes.data() + at, type, order_));
  }

  std::vector<std::uint32_t> numbers_at(std::uint64_t entry) const {
    const std::size_t size = bytes_of_type(number_at(entry + 2, 2));
    const std::uint64_t count = number_at(entry + 4, 4);
    if (size == 0 || count == 0 || count > file_.bytes.size() / size)
      throw io_error_at_byte(file_.path, entry, "expected numbers of type BYTE, SHORT or LONG within the file");
    const std::uint64_t at = count * size <= 4 ? entry + 8 : number_at(entry + 8, 4);
    std::vector<std::uint32_t> numbers;
    for (std::uint64_t i = 0; i < count; ++i)
      numbers.push_back(static_cast<std::uint32_t>(number_at(at + i * size, size)));
    return numbers;
  }

  const FileBytes& file_;
  ByteOrder order_ = ByteOrder::Little;
  std::uint64_t begin_ = 0, count_ = 0;
};

std::size_t side(const Directory& directory, Tag tag, const char* what, std::uint64_t otherwise = 0) {
  const std::uint64_t side = directory.number(tag, otherwise);
  if (side == 0 || side > kMaxSide)
    directory.fail(fmt::format("expected a {} of 1 to {} pixels, found {}", what, kMaxSide, side));
  return side;
}

ScalarType pixel_type(const Directory& directory) {
  constexpr std::uint64_t kUnsigned = 1, kSigned = 2, kFloat = 3;
  const std::uint64_t bits = directory.number(kBits, 1), format = directory.number(kSampleFormat, kUnsigned),
                      channels = directory.number(kChannels, 1);
  if (channels == 1 && bits == 16 && format == kUnsigned) return ScalarType::Uint16;
  if (channels == 1 && bits == 16 && format == kSigned) return ScalarType::Int16;
  if (channels == 1 && bits == 32 && format == kUnsigned) return ScalarType::Uint32;
  if (channels == 1 && bits == 32 && format == kFloat) return ScalarType::Float32;
  if (channels == 1 && bits == 64 && format == kFloat) return ScalarType::Float64;
  directory.fail(fmt::format("expected a depth image of 16-bit grey values or of floats, found {} channels of {} bits",
                             channels, bits));
}

TiffCompression compression(const Directory& directory) {
  const std::uint64_t number = directory.number(kCompressionTag, 1);
  if (number == 1) return TiffCompression::None;
  if (number == 5) return TiffCompression::Lzw;
  if (number == 8 || number == 32946) return TiffCompression::Deflate;
  if (number == 32773) return TiffCompression::PackBits;
  directory.fail(
      fmt::format("expected no compression, LZW, Deflate or PackBits, found number {}; tiffcp -c none IN OUT", number));
}

TiffPredictor predictor(const Directory& directory, ScalarType type) {
  const std::uint64_t number = directory.number(kPredictorTag, 1);
  if (number == 1) return TiffPredictor::None;
  if (number == 2) return TiffPredictor::Horizontal;
  if (number == 3 && is_floating(type)) return TiffPredictor::FloatingPoint;
  directory.fail(fmt::format("expected the predictor 1, 2, or of floats 3, found {}", number));
}

void take_blocks(const FileBytes& file, const Directory& directory, TiffImage& image) {
  image.offsets = directory.numbers(image.has_tiles ? kTileOffsets : kStripOffsets);
  image.num_bytes = directory.numbers(image.has_tiles ? kTileBytes : kStripBytes);
  const std::size_t count = image.num_blocks();
  if (image.offsets.size() != count || image.num_bytes.size() != count)
    directory.fail(fmt::format("expected {} strips or tiles, found {} and {} sizes", count, image.offsets.size(),
                               image.num_bytes.size()));
  for (std::size_t block = 0; block < count; ++block)
    if (std::uint64_t{image.offsets[block]} + image.num_bytes[block] > file.bytes.size())
      throw io_error_at_byte(file.path, file.bytes.size(),
                             fmt::format("expected {} bytes of a strip or tile at {}, the file ends here",
                                         image.num_bytes[block], image.offsets[block]));
}

}  // namespace

std::size_t TiffImage::rows_of_block(std::size_t block) const {
  const std::size_t first = block / blocks_per_row() * block_height;
  return has_tiles ? block_height : std::min(block_height, height - first);
}

TiffImage parse_tiff_directory(const FileBytes& file) {
  const Directory directory(file);
  TiffImage image;
  image.order = directory.order();
  image.width = side(directory, kWidth, "width");
  image.height = side(directory, kHeight, "height");
  image.type = pixel_type(directory);
  image.compression = compression(directory);
  image.predictor = predictor(directory, image.type);
  if (directory.number(kFillOrder, 1) != 1) directory.fail("expected bits in their usual order");
  image.has_tiles = directory.number(kTileWidth, 0) != 0;
  image.block_width = image.has_tiles ? side(directory, kTileWidth, "tile's width") : image.width;
  // A strip may be stated as endless.
  image.block_height = image.has_tiles
                           ? side(directory, kTileHeight, "tile's height")
                           : std::min<std::uint64_t>(directory.number(kRowsPerStrip, image.height), image.height);
  if (image.block_height == 0) directory.fail("expected strips of one row or more");
  take_blocks(file, directory, image);
  return image;
}

}  // namespace augicp
