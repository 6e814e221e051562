// SPDX-License-Identifier: MIT
#include "augicp/io/npy_header.h"

#include <cmath>
#include <limits>
#include <optional>
#include <string_view>
#include <utility>

#include "augicp/io/format.h"
#include "augicp/io/parse_number.h"
#include "augicp/io/text_lines.h"

namespace augicp {
namespace {

constexpr std::uint64_t kTextOffset = 10;  // for messages: where the dictionary begins in version 1
constexpr std::uint64_t kMaxItem = 65'536;

// The numbers that a point has in arrays that people write: position, normal, colour or intensity. More columns of
// three or four rows are coordinates as rows, homogeneous or not.
constexpr std::uint64_t kMostNumbers = 8;

// The text of the header, a Python dictionary, and its end.
std::string_view header_text(const FileBytes& file) {
  constexpr std::string_view kMark = "\x93NUMPY";
  constexpr std::uint64_t kMaxHeader = 65'536;
  const std::string_view bytes = file.bytes;
  if (!bytes.starts_with(kMark)) throw io_error_at_byte(file.path, 0, "expected the mark of a NumPy array");
  if (bytes.size() < 12) throw io_error_at_byte(file.path, bytes.size(), "expected a header, the file ends here");
  const char version = bytes[6];
  if (version < 1 || version > 3)
    throw io_error_at_byte(file.path, 6,
                           fmt::format("expected version 1, 2 or 3, found {}", static_cast<int>(version)));
  const ScalarType length_type = version == 1 ? ScalarType::Uint16 : ScalarType::Uint32;
  const auto length = static_cast<std::uint64_t>(read_scalar(bytes.data() + 8, length_type, ByteOrder::Little));
  const std::uint64_t begin = 8 + num_bytes(length_type);
  if (length > kMaxHeader || length > bytes.size() - begin)
    throw io_error_at_byte(file.path, 8,
                           fmt::format("expected a header of at most 64 KB within the file, found length {}", length));
  return bytes.substr(begin, length);
}

// The text after a key of the dictionary.
std::string_view value_of(const FileBytes& file, std::string_view header, std::string_view key) {
  const std::size_t at = header.find(fmt::format("'{}'", key));
  std::string_view rest = at == std::string_view::npos ? "" : trimmed(header.substr(at + key.size() + 2));
  if (!rest.starts_with(':'))
    throw io_error_at_byte(file.path, kTextOffset,
                           fmt::format("expected '{}' in the header, found {}", key, in_quotes(header)));
  rest.remove_prefix(1);
  return trimmed(rest);
}

// A type such as '<f4', without its quotes.
struct TypeCode {
  char kind = ' ';  // f, i, u, b, or V for bytes of no meaning
  std::uint64_t size = 0;
  ByteOrder order = ByteOrder::Little;

  std::optional<ScalarType> type() const {
    using enum ScalarType;
    if (kind == 'f') return size == 4 ? std::optional(Float32) : size == 8 ? std::optional(Float64) : std::nullopt;
    if (kind == 'b') return size == 1 ? std::optional(Uint8) : std::nullopt;
    if (kind != 'i' && kind != 'u') return std::nullopt;
    const bool is_signed = kind == 'i';
    if (size == 1) return is_signed ? Int8 : Uint8;
    if (size == 2) return is_signed ? Int16 : Uint16;
    if (size == 4) return is_signed ? Int32 : Uint32;
    return size == 8 ? std::optional(is_signed ? Int64 : Uint64) : std::nullopt;
  }
};

std::optional<TypeCode> type_code(std::string_view text) {
  if (text.size() < 3) return std::nullopt;
  const auto size = parse_count(text.substr(2));
  if (!size || *size == 0 || *size > kMaxItem || std::string_view("<>|=").find(text[0]) == std::string_view::npos)
    return std::nullopt;
  return TypeCode{text[1], *size, text[0] == '>' ? ByteOrder::Big : ByteOrder::Little};
}

// Takes the parts of a Python literal from the front of a text.
class LiteralParser {
 public:
  LiteralParser(const FileBytes& file, std::string_view text) : file_(file), text_(text), rest_(text) {}

  bool takes(char mark) {
    rest_ = trimmed(rest_);
    if (!rest_.starts_with(mark)) return false;
    rest_.remove_prefix(1);
    return true;
  }

  void take(char mark) {
    if (!takes(mark)) fail();
  }

  std::string_view take_string() {
    take('\'');
    const std::size_t end = rest_.find('\'');
    if (end == std::string_view::npos) fail();
    const std::string_view text = rest_.substr(0, end);
    rest_.remove_prefix(end + 1);
    return text;
  }

  TypeCode take_type() {
    const auto code = type_code(take_string());
    if (!code) fail();
    return *code;
  }

  // (3,) as 3.
  std::uint64_t take_count() {
    take('(');
    const std::size_t end = rest_.find(')');
    if (end == std::string_view::npos) fail();
    std::string_view inside = trimmed(rest_.substr(0, end));
    if (inside.ends_with(',')) inside.remove_suffix(1);
    const auto count = parse_count(trimmed(inside));
    if (!count || *count == 0 || *count > kMaxItem) fail();
    rest_.remove_prefix(end + 1);
    return *count;
  }

  [[noreturn]] void fail() const {
    throw io_error_at_byte(
        file_.path, kTextOffset,
        "expected numbers of float16, float32, float64 or an integer type, or named ones, found " + in_quotes(text_));
  }

 private:
  const FileBytes& file_;
  std::string_view text_, rest_;
};

// The members of a list such as [('x', '<f4'), ('', '|V4'), ('normal', '<f4', (3,))].
void parse_members(LiteralParser& parser, NpyHeader& header) {
  while (!parser.takes(']')) {
    parser.take('(');
    const std::string name(parser.take_string());
    parser.take(',');
    const TypeCode code = parser.take_type();
    const std::uint64_t count = parser.takes(',') ? parser.take_count() : 1;
    parser.take(')');
    parser.takes(',');
    const auto type = code.type();
    if (!type && code.kind != 'V') parser.fail();
    if (type) header.members.push_back({name, *type, code.order, count, header.item_bytes});
    header.item_bytes += code.size * count;
    if (header.item_bytes > kMaxItem) parser.fail();
  }
  if (header.members.empty()) parser.fail();
}

void parse_type(const FileBytes& file, std::string_view descr, NpyHeader& header) {
  LiteralParser parser(file, descr);
  if (parser.takes('[')) return parse_members(parser, header);
  const TypeCode code = parser.take_type();
  header.is_half = code.kind == 'f' && code.size == 2;
  const auto type = header.is_half ? std::optional(ScalarType::Float32) : code.type();
  if (!type) parser.fail();
  header.type = *type;
  header.order = code.order;
  header.item_bytes = code.size;
}

// The sides within the brackets, of 1 to 3; empty for any other text.
std::vector<std::uint64_t> sides_in(std::string_view value) {
  const std::size_t end = value.find(')');
  if (!value.starts_with('(') || end == std::string_view::npos) return {};
  std::string_view rest = value.substr(1, end - 1);
  std::vector<std::uint64_t> sides;
  while (const auto field = next_field(rest, ',')) {
    const auto side = parse_count(*field);
    if (!side || sides.size() == 3) return {};
    sides.push_back(*side);
  }
  return sides;
}

// The text up to its bracket.
std::string_view tuple_of(std::string_view value) { return value.substr(0, value.find(')') + 1); }

void check_shape_of_points(const FileBytes& file, const NpyHeader& header, std::string_view value) {
  const std::vector<std::uint64_t>& shape = header.shape;
  const bool fits =
      header.is_structured() ? shape.size() == 1 || shape.size() == 2 : shape.size() >= 2 && shape.back() >= 3;
  if (!fits)
    throw io_error_at_byte(
        file.path, kTextOffset,
        fmt::format("expected the shape {}, found {}",
                    header.is_structured() ? "(N,) or (H, W)" : "(N, 3) or (H, W, 3)", in_quotes(tuple_of(value))));
  if (!header.is_structured() && shape.size() == 2 && (shape[0] == 3 || shape[0] == 4) && shape[1] > kMostNumbers)
    throw io_error_at_byte(
        file.path, kTextOffset,
        fmt::format("expected the shape (N, 3), found {}: is it transposed?", in_quotes(tuple_of(value))));
}

struct Parsed {
  NpyHeader header;
  std::string_view shape;  // as it is written, with what follows
};

Parsed parse_any(const FileBytes& file) {
  const std::string_view text = header_text(file);
  NpyHeader header;
  parse_type(file, value_of(file, text, "descr"), header);
  const std::string_view fortran = value_of(file, text, "fortran_order");
  header.is_fortran = fortran.starts_with("True");
  if (!header.is_fortran && !fortran.starts_with("False"))
    throw io_error_at_byte(file.path, kTextOffset,
                           "expected True or False of 'fortran_order', found " + in_quotes(fortran));
  const std::string_view shape = value_of(file, text, "shape");
  header.shape = sides_in(shape);
  header.body_offset = static_cast<std::size_t>(text.data() + text.size() - file.bytes.data());
  return {std::move(header), shape};
}

}  // namespace

NpyHeader parse_npy_header(const FileBytes& file) {
  Parsed parsed = parse_any(file);
  check_shape_of_points(file, parsed.header, parsed.shape);
  return std::move(parsed.header);
}

NpyHeader parse_npy_image_header(const FileBytes& file) {
  Parsed parsed = parse_any(file);
  std::vector<std::uint64_t>& shape = parsed.header.shape;
  if (shape.size() == 3 && shape.back() == 1) shape.pop_back();
  if (shape.size() == 3 && shape.front() == 1) shape.erase(shape.begin());
  if (parsed.header.is_structured() || shape.size() != 2)
    throw io_error_at_byte(file.path, kTextOffset,
                           "expected a depth image of the shape (H, W), found " + in_quotes(tuple_of(parsed.shape)));
  return std::move(parsed.header);
}

float number_of_half(std::uint16_t half) {
  const int exponent = half >> 10 & 31, fraction = half & 1023;
  const float sign = (half & 0x8000) != 0 ? -1.0f : 1.0f;
  if (exponent == 31)
    return fraction == 0 ? sign * std::numeric_limits<float>::infinity() : std::numeric_limits<float>::quiet_NaN();
  return sign * (exponent == 0 ? std::ldexp(static_cast<float>(fraction), -24)
                               : std::ldexp(static_cast<float>(fraction + 1024), exponent - 25));
}

}  // namespace augicp
