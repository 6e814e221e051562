// SPDX-License-Identifier: MIT
#include <algorithm>
#include <string_view>

#include "augicp/io/depth_formats.h"
#include "augicp/io/format.h"
#include "augicp/io/parse_number.h"
#include "augicp/io/scalar_type.h"

namespace augicp {
namespace {

// The words of a header, in which '#' begins a comment.
class PnmHeader {
 public:
  explicit PnmHeader(const FileBytes& file) : file_(file), text_(file.bytes) {}

  std::uint64_t next_number(const char* what) {
    skip_blanks();
    const std::size_t end = std::min(text_.find_first_not_of("0123456789", at_), text_.size());
    const auto number = parse_count(text_.substr(at_, end - at_));
    if (!number) throw io_error_at_byte(file_.path, at_, fmt::format("expected {}", what));
    at_ = end;
    return *number;
  }

  double next_real(const char* what) {
    skip_blanks();
    const std::size_t end = std::min(text_.find_first_of(" \t\r\n", at_), text_.size());
    const auto number = parse_double(text_.substr(at_, end - at_));
    if (!number || !(*number < 0.0 || *number > 0.0))
      throw io_error_at_byte(file_.path, at_, fmt::format("expected {}", what));
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

// Whether the values fill the file behind its header.
void check_body(const FileBytes& file, std::size_t begin, std::size_t count, std::size_t value_bytes) {
  const std::size_t size = file.bytes.size(), body = value_bytes * count;
  if (begin > size || size - begin < body)
    throw io_error_at_byte(file.path, size, fmt::format("expected {} values, the file ends here", count));
  if (size - begin > body) throw io_error_at_byte(file.path, begin + body, "expected the end of the image, found more");
}

}  // namespace

DepthImage parse_depth_pgm(const FileBytes& file, double depth_scale) {
  constexpr std::uint64_t kEightBits = 255, kSixteenBits = 65535;
  if (!file.bytes.starts_with("P5")) throw io_error_at_byte(file.path, 0, "expected 'P5', the mark of a binary PGM");
  PnmHeader header(file);
  header.skip(2);
  const std::uint64_t width = header.next_number("a width"), height = header.next_number("a height"),
                      largest = header.next_number("the largest value");
  check_image_sides(file, width, height);
  if (largest <= kEightBits || largest > kSixteenBits)
    throw io_error(file.path,
                   fmt::format("expected a depth image of 16-bit grey values, found values up to {}", largest));
  const std::size_t begin = header.body_offset();
  check_body(file, begin, width * height, 2);
  return depth_of_values(width, height, DepthUnit{depth_scale}, [&](std::size_t v, std::size_t u) {
    return read_scalar(file.bytes.data() + begin + 2 * (v * width + u), ScalarType::Uint16, ByteOrder::Big);
  });
}

DepthImage parse_depth_pfm(const FileBytes& file, double) {
  if (!file.bytes.starts_with("Pf"))
    throw io_error_at_byte(file.path, 0, "expected 'Pf', the mark of a PFM of one channel");
  PnmHeader header(file);
  header.skip(2);
  const std::uint64_t width = header.next_number("a width"), height = header.next_number("a height");
  const double scale = header.next_real("a scale, whose sign states the byte order");
  check_image_sides(file, width, height);
  const std::size_t begin = header.body_offset();
  check_body(file, begin, width * height, 4);
  const ByteOrder order = scale < 0.0 ? ByteOrder::Little : ByteOrder::Big;
  return depth_of_values(width, height, DepthUnit{}, [&](std::size_t v, std::size_t u) {
    return read_scalar(file.bytes.data() + begin + 4 * ((height - 1 - v) * width + u), ScalarType::Float32, order);
  });
}

}  // namespace augicp
