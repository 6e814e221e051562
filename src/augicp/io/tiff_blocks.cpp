// SPDX-License-Identifier: MIT
#include "augicp/io/tiff_blocks.h"

#include <zlib.h>

#include <algorithm>
#include <array>
#include <cstdint>

namespace augicp {
namespace {

std::optional<std::string> inflated(std::string_view bytes, std::size_t size) {
  std::string content(size, '\0');
  z_stream stream{};
  if (inflateInit(&stream) != Z_OK) return std::nullopt;
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(bytes.data()));
  stream.avail_in = static_cast<uInt>(bytes.size());
  stream.next_out = reinterpret_cast<Bytef*>(content.data());
  stream.avail_out = static_cast<uInt>(size);
  const int code = inflate(&stream, Z_FINISH);
  const bool is_whole = stream.avail_out == 0 && (code == Z_STREAM_END || code == Z_BUF_ERROR || code == Z_OK);
  inflateEnd(&stream);
  return is_whole ? std::optional(std::move(content)) : std::nullopt;
}

// Runs: n + 1 bytes as they are, or one byte 1 - n times; -128 is nothing. Section 9.
std::optional<std::string> unpacked_bits(std::string_view bytes, std::size_t size) {
  std::string content;
  while (content.size() < size && !bytes.empty()) {
    const int n = static_cast<signed char>(bytes[0]);
    bytes.remove_prefix(1);
    if (n == -128) continue;
    const std::size_t taken = n >= 0 ? static_cast<std::size_t>(n) + 1 : 1;
    if (bytes.size() < taken) return std::nullopt;
    if (n >= 0) {
      content.append(bytes.substr(0, taken));
    } else {
      content.append(static_cast<std::size_t>(1 - n), bytes[0]);
    }
    bytes.remove_prefix(taken);
  }
  if (content.size() < size) return std::nullopt;
  content.resize(size);
  return content;
}

// Section 13: codes of 9 to 12 bits, the most significant bit first; a code is a string that is known, and makes known
// itself with the first byte of the next one.
class LzwReader {
 public:
  explicit LzwReader(std::string_view bytes) : bytes_(bytes) {}

  std::optional<std::string> read(std::size_t size) {
    std::string content;
    std::uint32_t last = kClear;
    while (content.size() < size) {
      const auto code = next_code();
      if (!code || *code == kEnd) return std::nullopt;
      if (*code == kClear) {
        num_codes_ = kFirstFree;
        last = kClear;
        continue;
      }
      if (last == kClear) {
        if (*code >= kClear) return std::nullopt;
        content += static_cast<char>(*code);
      } else if (!append(*code, last, content)) {
        return std::nullopt;
      }
      last = *code;
    }
    content.resize(size);
    return content;
  }

 private:
  static constexpr std::uint32_t kClear = 256, kEnd = 257, kFirstFree = 258, kMostCodes = 4096;
  struct Entry {
    std::size_t begin = 0, size = 0;  // of its string in the content
  };

  // The width grows one code early.
  std::optional<std::uint32_t> next_code() {
    const std::uint32_t width = num_codes_ < 511 ? 9 : num_codes_ < 1023 ? 10 : num_codes_ < 2047 ? 11 : 12;
    while (num_bits_ < width) {
      if (bytes_.empty()) return std::nullopt;
      bits_ = bits_ << 8 | static_cast<unsigned char>(bytes_[0]);
      bytes_.remove_prefix(1);
      num_bits_ += 8;
    }
    num_bits_ -= width;
    const std::uint32_t code = bits_ >> num_bits_ & ((1u << width) - 1);
    bits_ &= (1u << num_bits_) - 1;
    return code;
  }

  // Appends the string of a code, and makes known the string of the code before with its first byte: that is what the
  // content has there.
  bool append(std::uint32_t code, std::uint32_t last, std::string& content) {
    if (num_codes_ == kMostCodes || code > num_codes_ || code == kEnd) return false;
    const std::size_t last_size = last < kClear ? 1 : entries_[last].size;
    entries_[num_codes_++] = {content.size() - last_size, last_size + 1};
    if (code < kClear) {
      content += static_cast<char>(code);
      return true;
    }
    const Entry entry = entries_[code];
    for (std::size_t i = 0; i < entry.size; ++i) content += content[entry.begin + i];  // it may reach into itself
    return true;
  }

  std::string_view bytes_;
  std::uint32_t bits_ = 0, num_bits_ = 0, num_codes_ = kFirstFree;
  std::array<Entry, kMostCodes> entries_{};
};

// Each pixel is the difference from the one before, in whole numbers of its size.
void sum_pixels(const TiffImage& image, char* row) {
  const std::size_t size = num_bytes(image.type);
  for (std::size_t u = 1; u < image.block_width; ++u) {
    unsigned carry = 0;
    for (std::size_t k = 0; k < size; ++k) {  // from the least significant byte
      const std::size_t at = image.order == ByteOrder::Little ? k : size - 1 - k;
      carry += static_cast<unsigned char>(row[(u - 1) * size + at]) + static_cast<unsigned char>(row[u * size + at]);
      row[u * size + at] = static_cast<char>(carry & 255);
      carry >>= 8;
    }
  }
}

// Bytes are differences. A row has the most significant bytes of all its pixels first, then the next ones.
void join_bytes(const TiffImage& image, char* row) {
  const std::size_t size = num_bytes(image.type), width = image.block_width;
  for (std::size_t i = 1; i < width * size; ++i) row[i] = static_cast<char>(row[i] + row[i - 1]);
  const std::string planes(row, width * size);
  for (std::size_t u = 0; u < width; ++u)
    for (std::size_t k = 0; k < size; ++k) row[u * size + k] = planes[k * width + u];
}

}  // namespace

std::optional<std::string> decompressed_block(TiffCompression compression, std::string_view bytes, std::size_t size) {
  switch (compression) {
    case TiffCompression::Lzw:
      return LzwReader(bytes).read(size);
    case TiffCompression::Deflate:
      return inflated(bytes, size);
    case TiffCompression::PackBits:
      return unpacked_bits(bytes, size);
    case TiffCompression::None:
      break;
  }
  return bytes.size() < size ? std::nullopt : std::optional(std::string(bytes.substr(0, size)));
}

void undo_predictor(const TiffImage& image, std::string& rows) {
  if (image.predictor == TiffPredictor::None) return;
  const std::size_t row_bytes = image.block_width * num_bytes(image.type);
  for (std::size_t at = 0; at + row_bytes <= rows.size(); at += row_bytes) {
    if (image.predictor == TiffPredictor::Horizontal) sum_pixels(image, rows.data() + at);
    if (image.predictor == TiffPredictor::FloatingPoint) join_bytes(image, rows.data() + at);
  }
}

}  // namespace augicp
