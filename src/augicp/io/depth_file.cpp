// SPDX-License-Identifier: MIT
#include "augicp/io/depth_file.h"

#include <limits>
#include <vector>

#include "augicp/core/check.h"
#include "augicp/io/binary_points.h"
#include "augicp/io/format.h"
#include "augicp/io/npy_header.h"
#include "augicp/io/parse_number.h"
#include "augicp/io/text_lines.h"

namespace augicp {
namespace {

constexpr std::uint64_t kMaxSide = 16384;

void check_sides(const FileBytes& file, std::uint64_t width, std::uint64_t height) {
  if (width == 0 || height == 0 || width > kMaxSide || height > kMaxSide)
    throw io_error(file.path,
                   fmt::format("expected an image of 1 to {} pixels a side, found {} x {}", kMaxSide, width, height));
}

// ---- PGM

// The words of a header, in which '#' begins a comment.
class PgmHeader {
 public:
  explicit PgmHeader(const FileBytes& file) : file_(file), text_(file.bytes) {}

  std::uint64_t next_number(const char* what) {
    skip_blanks();
    const std::size_t end = std::min(text_.find_first_not_of("0123456789", at_), text_.size());
    const auto number = parse_count(text_.substr(at_, end - at_));
    if (!number) throw io_error_at_byte(file_.path, at_, fmt::format("expected {}", what));
    at_ = end;
    return *number;
  }

  // One blank ends the header.
  std::size_t body_offset() const { return at_ + 1; }
  void skip(std::size_t count) { at_ += count; }

 private:
  void skip_blanks() {
    constexpr std::string_view kBlanks = " \t\r\n";
    while (at_ < text_.size() && (kBlanks.find(text_[at_]) != std::string_view::npos || text_[at_] == '#'))
      at_ = text_[at_] == '#' ? std::min(text_.find('\n', at_), text_.size()) : at_ + 1;
  }

  const FileBytes& file_;
  std::string_view text_;
  std::size_t at_ = 0;
};

DepthImage parse_pgm(const FileBytes& file, double depth_scale) {
  constexpr std::uint64_t kEightBits = 255, kSixteenBits = 65535;
  if (!file.bytes.starts_with("P5")) throw io_error_at_byte(file.path, 0, "expected 'P5', the mark of a binary PGM");
  PgmHeader header(file);
  header.skip(2);
  const std::uint64_t width = header.next_number("a width"), height = header.next_number("a height"),
                      largest = header.next_number("the largest value");
  check_sides(file, width, height);
  if (largest <= kEightBits || largest > kSixteenBits)
    throw io_error(file.path,
                   fmt::format("expected a depth image of 16-bit grey values, found values up to {}", largest));
  const std::size_t count = width * height, begin = header.body_offset();
  if (begin > file.bytes.size() || file.bytes.size() - begin < 2 * count)
    throw io_error_at_byte(file.path, file.bytes.size(), fmt::format("expected {} values, the file ends here", count));
  if (file.bytes.size() - begin > 2 * count)
    throw io_error_at_byte(file.path, begin + 2 * count, "expected the end of the image, found more");
  std::vector<std::uint16_t> values(count);
  for (std::size_t i = 0; i < count; ++i)
    values[i] =
        static_cast<std::uint16_t>(read_scalar(file.bytes.data() + begin + 2 * i, ScalarType::Uint16, ByteOrder::Big));
  return depth_image(values, static_cast<int>(width), static_cast<int>(height), depth_scale);
}

// ---- NPY

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
  check_sides(file, width, height);
  if (file.bytes.size() - header.body_offset != width * height * header.item_bytes)
    throw io_error_at_byte(
        file.path, file.bytes.size(),
        fmt::format("expected {} values, found {} bytes", width * height, file.bytes.size() - header.body_offset));
  const bool are_metres = is_floating(header.type);
  const double no_reading = are_metres ? std::numeric_limits<double>::infinity() : 65535.0;
  std::vector<float> values(width * height);
  for (std::size_t v = 0; v < height; ++v)
    for (std::size_t u = 0; u < width; ++u) {
      const double value = value_at(file, header, v, u);
      values[v * width + u] = value == no_reading ? 0.0f : static_cast<float>(value);
    }
  return depth_image(values, static_cast<int>(width), static_cast<int>(height), are_metres ? 1.0 : depth_scale);
}

}  // namespace

bool is_image_file(const std::filesystem::path& path) {
  const std::string extension = lower_case_extension(path);
  return extension == ".png" || extension == ".pgm";
}

DepthImage parse_depth_image(const FileBytes& file, double depth_scale) {
  require_positive("depth_scale", depth_scale);
  const std::string extension = lower_case_extension(file.path);
  if (extension == ".pgm") return parse_pgm(file, depth_scale);
  return extension == ".npy" ? parse_npy_depth(file, depth_scale) : parse_depth_png(file, depth_scale);
}

DepthImage read_depth_image(const std::filesystem::path& path, double depth_scale) {
  require_positive("depth_scale", depth_scale);
  return parse_depth_image(read_bytes(path), depth_scale);
}

}  // namespace augicp
