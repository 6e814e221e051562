// SPDX-License-Identifier: MIT
#include "augicp/io/read_npy.h"

#include <vector>

#include "augicp/io/binary_points.h"
#include "augicp/io/cloud_builder.h"
#include "augicp/io/format.h"
#include "augicp/io/parse_number.h"
#include "augicp/io/text_lines.h"

namespace augicp {
namespace {

struct NpyHeader {
  ScalarType type = ScalarType::Float64;
  ByteOrder order = ByteOrder::Little;
  bool is_fortran = false;
  std::vector<std::uint64_t> shape;
  std::size_t body_offset = 0;
};

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
    throw io_error_at_byte(file.path, 10, fmt::format("expected '{}' in the header, found {}", key, in_quotes(header)));
  rest.remove_prefix(1);
  return trimmed(rest);
}

// The numbers that a point has in arrays that people write: position, normal, colour or intensity. More columns of
// three or four rows are coordinates as rows, homogeneous or not.
constexpr std::uint64_t kMostNumbers = 8;

std::vector<std::uint64_t> shape_of(const FileBytes& file, std::string_view value) {
  const auto fail = [&] {
    return io_error_at_byte(file.path, 10, "expected the shape (N, 3) or (H, W, 3), found " + in_quotes(value));
  };
  const std::size_t end = value.find(')');
  if (!value.starts_with('(') || end == std::string_view::npos) throw fail();
  std::string_view rest = value.substr(1, end - 1);
  std::vector<std::uint64_t> shape;
  while (const auto field = next_field(rest, ',')) {
    const auto side = parse_count(*field);
    if (!side || shape.size() == 3) throw fail();
    shape.push_back(*side);
  }
  if (shape.size() < 2 || shape.back() < 3) throw fail();
  if (shape.size() == 2 && (shape[0] == 3 || shape[0] == 4) && shape[1] > kMostNumbers)
    throw io_error_at_byte(
        file.path, 10,
        fmt::format("expected the shape (N, 3), found {}: is it transposed?", in_quotes(value.substr(0, end + 1))));
  return shape;
}

NpyHeader parse_header(const FileBytes& file) {
  const std::string_view text = header_text(file);
  NpyHeader header;
  const std::string_view descr = value_of(file, text, "descr"), fortran = value_of(file, text, "fortran_order");
  const std::string_view type = descr.substr(0, 5);
  if (type != "'<f4'" && type != "'<f8'" && type != "'>f4'" && type != "'>f8'")
    throw io_error_at_byte(file.path, 10, "expected numbers of float32 or float64, found " + in_quotes(descr));
  header.order = type[1] == '>' ? ByteOrder::Big : ByteOrder::Little;
  header.type = type[3] == '4' ? ScalarType::Float32 : ScalarType::Float64;
  header.is_fortran = fortran.starts_with("True");
  if (!header.is_fortran && !fortran.starts_with("False"))
    throw io_error_at_byte(file.path, 10, "expected True or False of 'fortran_order', found " + in_quotes(fortran));
  header.shape = shape_of(file, value_of(file, text, "shape"));
  header.body_offset = static_cast<std::size_t>(text.data() + text.size() - file.bytes.data());
  return header;
}

// The number of items in the array. Throws IoError if the file is shorter.
std::uint64_t checked_num_items(const FileBytes& file, const NpyHeader& header) {
  const std::uint64_t available = (file.bytes.size() - header.body_offset) / num_bytes(header.type);
  std::uint64_t count = 1;
  for (const std::uint64_t side : header.shape) {
    if (side == 0) throw io_error(file.path, "holds no points");
    if (side > available / count)
      throw io_error_at_byte(file.path, file.bytes.size(),
                             fmt::format("expected {} numbers and more, the file has {}", side, available));
    count *= side;
  }
  return count;
}

}  // namespace

CloudFile parse_npy(const FileBytes& file, const ReadOptions& options) {
  const NpyHeader header = parse_header(file);
  const std::uint64_t num_items = checked_num_items(file, header);
  const std::size_t item = num_bytes(header.type);
  const std::size_t num_columns = header.shape.back();
  const std::size_t num_rows = header.shape.size() == 3 ? header.shape[0] : 1;
  const std::size_t row_length = header.shape[header.shape.size() - 2];
  check_num_points(file.path, num_rows * row_length, options);

  BinaryPoints points{file.bytes, header.order, {}, num_rows, row_length};
  const auto column_at = [&](std::size_t column) {
    return header.is_fortran ? BinaryColumn{header.body_offset + column * num_rows * row_length * item, num_rows * item,
                                            item, header.type}
                             : BinaryColumn{header.body_offset + column * item, num_columns * item,
                                            row_length * num_columns * item, header.type};
  };
  for (std::size_t axis = 0; axis < 3; ++axis) points.columns[axis] = column_at(axis);
  const int width = header.shape.size() == 3 ? static_cast<int>(row_length) : 0;
  PointTable table{"npy", num_rows * row_length, false, width, std::nullopt};
  for (std::size_t column = 3; column < num_columns && options.keep_fields; ++column) {
    table.fields.push_back({fmt::format("column_{}", column + 1), header.type, 1, {}});
    points.fields.push_back(column_at(column));
  }
  CloudFile read = build_cloud(file, table, [&](CloudBuilder& builder) { add_points(points, builder); });
  if (const std::uint64_t excess = file.bytes.size() - header.body_offset - num_items * item; excess > 0)
    read.report.warnings.push_back(fmt::format("{} bytes after the array were not read", excess));
  return read;
}

}  // namespace augicp
