// SPDX-License-Identifier: MIT
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <zlib.h>

#include <bit>
#include <cmath>
#include <map>
#include <random>

#include "augicp/io/depth_file.h"
#include "augicp/io/reader_testing.h"

namespace augicp {
namespace {

using ::testing::HasSubstr;

// A TIFF file as this test writes it.
struct Tiff {
  bool is_big = false;
  std::size_t width = 0, height = 0, block_width = 0, block_height = 0;  // strips if a block is as wide as the image
  std::uint32_t bits = 16, format = 1, compression = 1, predictor = 1;
  std::function<std::uint64_t(std::size_t v, std::size_t u)> bits_at;  // of a pixel, as a whole number
};

std::string number(std::uint64_t value, std::size_t size, bool is_big) {
  std::string bytes;
  for (std::size_t k = 0; k < size; ++k) bytes += static_cast<char>(value >> 8 * (is_big ? size - 1 - k : k));
  return bytes;
}

std::string lzw(const std::string& content) {
  std::map<std::string, std::uint32_t> known;
  std::string bytes, string;
  std::uint64_t bits = 0;
  std::uint32_t num_bits = 0, width = 9, next = 0;
  const auto put = [&](std::uint32_t code) {
    bits = bits << width | code;
    for (num_bits += width; num_bits >= 8; num_bits -= 8) bytes += static_cast<char>(bits >> (num_bits - 8));
  };
  const auto clear = [&] {
    put(256);
    known.clear();
    for (std::uint32_t i = 0; i < 256; ++i) known[std::string(1, static_cast<char>(i))] = i;
    next = 258;
    width = 9;
  };
  clear();
  for (const char c : content) {
    if (known.count(string + c)) {
      string += c;
      continue;
    }
    put(known[string]);
    known[string + c] = next++;
    string = std::string(1, c);
    if (next == 511 + 1 || next == 1023 + 1 || next == 2047 + 1) ++width;
    if (next == 4094 + 1) clear();
  }
  if (!string.empty()) put(known[string]);
  put(257);
  put(0);  // the rest of the last byte
  return bytes;
}

std::string compressed(const std::string& content, std::uint32_t compression) {
  if (compression == 5) return lzw(content);
  if (compression == 32773) {
    std::string bytes;
    for (std::size_t at = 0; at < content.size(); at += 100)
      bytes += static_cast<char>(std::min<std::size_t>(100, content.size() - at) - 1) + content.substr(at, 100);
    return bytes;
  }
  if (compression != 8) return content;
  uLongf size = compressBound(content.size());
  std::string bytes(size, '\0');
  compress(reinterpret_cast<Bytef*>(bytes.data()), &size, reinterpret_cast<const Bytef*>(content.data()),
           content.size());
  return bytes.substr(0, size);
}

// A row of a block, with its predictor; pixels outside of the image are zero.
std::string row_of(const Tiff& tiff, std::size_t v, std::size_t first) {
  const std::size_t size = tiff.bits / 8;
  std::vector<std::uint64_t> pixels;
  for (std::size_t u = first; u < first + tiff.block_width; ++u)
    pixels.push_back(u < tiff.width && v < tiff.height ? tiff.bits_at(v, u) : 0);
  std::string row;
  if (tiff.predictor == 3) {
    for (std::size_t k = 0; k < size; ++k)
      for (const std::uint64_t pixel : pixels) row += static_cast<char>(pixel >> 8 * (size - 1 - k));
    for (std::size_t i = row.size() - 1; i > 0; --i) row[i] = static_cast<char>(row[i] - row[i - 1]);
    return row;
  }
  if (tiff.predictor == 2)
    for (std::size_t u = pixels.size() - 1; u > 0; --u) pixels[u] -= pixels[u - 1];
  for (const std::uint64_t pixel : pixels) row += number(pixel, size, tiff.is_big);
  return row;
}

std::vector<std::string> blocks_of(const Tiff& tiff) {
  const bool are_tiles = tiff.block_width != tiff.width;
  std::vector<std::string> blocks;
  for (std::size_t top = 0; top < tiff.height; top += tiff.block_height)
    for (std::size_t left = 0; left < tiff.width; left += tiff.block_width) {
      std::string rows;
      for (std::size_t v = top; v < top + tiff.block_height && (are_tiles || v < tiff.height); ++v)
        rows += row_of(tiff, v, left);
      blocks.push_back(compressed(rows, tiff.compression));
    }
  return blocks;
}

std::string file_of(const Tiff& tiff) {
  const bool are_tiles = tiff.block_width != tiff.width;
  const auto num = [&](std::uint64_t value, std::size_t size) { return number(value, size, tiff.is_big); };
  std::string body, offsets, sizes;
  const std::vector<std::string> blocks = blocks_of(tiff);
  for (const std::string& block : blocks) {
    offsets += num(8 + body.size(), 4);
    sizes += num(block.size(), 4);
    body += block;
  }
  const std::uint64_t lists = 8 + body.size(), count = blocks.size();
  std::string entries;
  std::uint64_t num_entries = 0;
  const auto add = [&](std::uint32_t tag, std::uint64_t n, const std::string& value) {
    entries += num(tag, 2) + num(4, 2) + num(n, 4) + value;
    ++num_entries;
  };
  for (const auto& [tag, value] : std::map<std::uint32_t, std::uint64_t>{
           {256, tiff.width},
           {257, tiff.height},
           {258, tiff.bits},
           {259, tiff.compression},
           {277, 1},
           {317, tiff.predictor},
           {339, tiff.format},
           {are_tiles ? 322 : 278, are_tiles ? tiff.block_width : tiff.block_height}})
    add(tag, 1, num(value, 4));
  if (are_tiles) add(323, 1, num(tiff.block_height, 4));
  add(are_tiles ? 324 : 273, count, count == 1 ? offsets : num(lists, 4));
  add(are_tiles ? 325 : 279, count, count == 1 ? sizes : num(lists + 4 * count, 4));
  const std::string directory = num(num_entries, 2) + entries + num(0, 4);
  return (tiff.is_big ? "MM" : "II") + num(42, 2) + num(lists + 8 * count, 4) + body + offsets + sizes + directory;
}

// An image of 37 x 29 with smooth and rough parts: value / 1000 is the depth.
constexpr std::size_t kWidth = 37, kHeight = 29;
double value_at(std::size_t v, std::size_t u) {
  std::mt19937 random(static_cast<unsigned>(v * kWidth + u));
  return u < 20 ? static_cast<double>(1500 + 3 * u + v) : static_cast<double>(1 + random() % 4000);
}

Tiff integers() {
  Tiff tiff;
  tiff.width = tiff.block_width = kWidth;
  tiff.height = tiff.block_height = kHeight;
  tiff.bits_at = [](std::size_t v, std::size_t u) { return static_cast<std::uint64_t>(value_at(v, u)); };
  return tiff;
}

Tiff floats(std::uint32_t bits) {
  Tiff tiff = integers();
  tiff.bits = bits;
  tiff.format = 3;
  tiff.bits_at = [bits](std::size_t v, std::size_t u) -> std::uint64_t {
    const double metres = value_at(v, u) / 1000.0;
    return bits == 64 ? std::bit_cast<std::uint64_t>(metres) : std::bit_cast<std::uint32_t>(static_cast<float>(metres));
  };
  return tiff;
}

void expect_the_image(const Tiff& tiff) {
  SCOPED_TRACE(::testing::Message() << tiff.bits << " bits, compression " << tiff.compression << ", predictor "
                                    << tiff.predictor << ", big " << tiff.is_big << ", block " << tiff.block_width
                                    << " x " << tiff.block_height);
  const DepthImage image = parse_depth_image({"a.tif", file_of(tiff)}, 1000.0);
  ASSERT_EQ(image.width, static_cast<int>(kWidth));
  ASSERT_EQ(image.height, static_cast<int>(kHeight));
  for (std::size_t v = 0; v < kHeight; ++v)
    for (std::size_t u = 0; u < kWidth; ++u)
      ASSERT_FLOAT_EQ(image.depth[v * kWidth + u], static_cast<float>(value_at(v, u) / 1000.0)) << v << " " << u;
}

TEST(DepthTiff, EveryLayoutHasTheSameImage) {
  for (Tiff tiff : {integers(), floats(32), floats(64)})
    for (const bool is_big : {false, true})
      for (const std::uint32_t compression : {1u, 5u, 8u, 32773u})
        for (const std::uint32_t predictor : {1u, 2u, 3u}) {
          if (predictor == 3 && tiff.format != 3) continue;
          tiff.is_big = is_big;
          tiff.compression = compression;
          tiff.predictor = predictor;
          for (const auto& [width, height] : {std::pair(kWidth, kHeight), {kWidth, 7}, {16, 16}}) {
            tiff.block_width = width;
            tiff.block_height = height;
            expect_the_image(tiff);
          }
        }
}

// Long enough for codes of 12 bits, and for a table that is full.
TEST(DepthTiff, LzwIsReadBeyondAFullTable) {
  Tiff tiff = integers();
  tiff.width = tiff.block_width = 200;
  tiff.height = tiff.block_height = 150;
  tiff.compression = 5;
  const DepthImage image = parse_depth_image({"a.tif", file_of(tiff)}, 1000.0);
  for (std::size_t v = 0; v < tiff.height; ++v)
    for (std::size_t u = 0; u < tiff.width; ++u)
      ASSERT_FLOAT_EQ(image.depth[v * tiff.width + u], static_cast<float>(value_at(v, u) / 1000.0)) << v << " " << u;
}

std::string tiff_refusal(const std::string& bytes) {
  try {
    parse_depth_image({"a.tif", bytes}, 1000.0);
  } catch (const IoError& error) {
    return error.what();
  }
  return "";
}

TEST(DepthTiff, CutsAreRefused) {
  for (const std::uint32_t compression : {1u, 5u, 8u, 32773u}) {
    Tiff tiff = floats(32);
    tiff.compression = compression;
    const std::string bytes = file_of(tiff);
    for (std::size_t length = 0; length < bytes.size(); ++length)
      ASSERT_THAT(tiff_refusal(bytes.substr(0, length)), HasSubstr("a.tif: ")) << compression << ", " << length;
  }
}

TEST(DepthTiff, OtherImagesAreRefused) {
  const auto with = [](auto change) {
    Tiff tiff = integers();
    change(tiff);
    return tiff_refusal(file_of(tiff));
  };
  EXPECT_THAT(with([](Tiff& tiff) { tiff.bits = 8; }), HasSubstr("found 1 channels of 8 bits"));
  EXPECT_THAT(with([](Tiff& tiff) { tiff.predictor = 3; }), HasSubstr("predictor"));
  EXPECT_THAT(with([](Tiff& tiff) { tiff.compression = 7; }), HasSubstr("found number 7"));
  EXPECT_THAT(tiff_refusal("II+\0\0\0\0\0\0"), HasSubstr("II"));
  EXPECT_THAT(tiff_refusal(std::string("II\x2b\0\x08\0\0\0", 8)), HasSubstr("BigTIFF"));
  EXPECT_THAT(tiff_refusal("\x89PNG\r\n\x1a\n"), HasSubstr("expected 'II' or 'MM'"));
  std::string two = file_of(integers());
  two[two.size() - 4] = 8;
  EXPECT_THAT(tiff_refusal(two), HasSubstr("several images"));
}

}  // namespace
}  // namespace augicp
