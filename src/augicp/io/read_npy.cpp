// SPDX-License-Identifier: MIT
#include "augicp/io/read_npy.h"

#include <algorithm>
#include <cstring>

#include "augicp/io/binary_points.h"
#include "augicp/io/cloud_builder.h"
#include "augicp/io/format.h"
#include "augicp/io/npy_header.h"

namespace augicp {
namespace {

// Rows and points in a row of an array, and numbers a point of a plain one.
struct Sides {
  std::size_t num_rows = 1, row_length = 0, num_columns = 1;

  std::size_t num_points() const { return num_rows * row_length; }
};

Sides sides_of(const NpyHeader& header) {
  const std::vector<std::uint64_t>& shape = header.shape;
  const std::size_t num_sides = shape.size() - (header.is_structured() ? 0 : 1);
  return {num_sides == 2 ? shape[0] : 1, shape[num_sides - 1], header.is_structured() ? 1 : shape.back()};
}

// The number of items in the array. Throws IoError if the file is shorter.
std::uint64_t checked_num_items(const FileBytes& file, const NpyHeader& header) {
  const std::uint64_t available = (file.bytes.size() - header.body_offset) / header.item_bytes;
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

// The numbers of a float16 array as float32 of the machine's own order.
std::string widened(std::string_view halves, ByteOrder order) {
  std::string floats(2 * halves.size(), '\0');
  for (std::size_t at = 0; at < halves.size(); at += 2) {
    const auto half = static_cast<std::uint16_t>(read_scalar(halves.data() + at, ScalarType::Uint16, order));
    const float number = number_of_half(half);
    std::memcpy(floats.data() + 2 * at, &number, sizeof(number));
  }
  return floats;
}

// A plain array: a point begins with x y z.
void add_plain_columns(const NpyHeader& header, const Sides& sides, bool with_fields, BinaryPoints& points,
                       PointTable& table) {
  const std::size_t item = num_bytes(header.type);
  const auto column_at = [&](std::size_t column) {
    return header.is_fortran
               ? BinaryColumn{column * sides.num_points() * item, sides.num_rows * item, item, header.type}
               : BinaryColumn{column * item, sides.num_columns * item, sides.row_length * sides.num_columns * item,
                              header.type};
  };
  for (std::size_t axis = 0; axis < 3; ++axis) points.columns[axis] = column_at(axis);
  for (std::size_t column = 3; column < sides.num_columns && with_fields; ++column) {
    table.fields.push_back({fmt::format("column_{}", column + 1), header.type, 1, {}});
    points.fields.push_back(column_at(column));
  }
}

// Single bytes have any.
ByteOrder order_of(const std::vector<NpyMember>& members) {
  const auto member =
      std::find_if(members.begin(), members.end(), [](const NpyMember& m) { return num_bytes(m.type) > 1; });
  return member == members.end() ? ByteOrder::Little : member->order;
}

// A structured array: columns by their names.
void add_members(const FileBytes& file, const NpyHeader& header, const Sides& sides, bool with_fields,
                 BinaryPoints& points, PointTable& table) {
  std::vector<std::string> names;
  for (const NpyMember& member : header.members) names.push_back(member.name);
  const PointColumns columns = find_columns(file.path, names);
  const std::size_t item = header.item_bytes;
  for (std::size_t i = 0; i < header.members.size(); ++i) {
    const NpyMember& member = header.members[i];
    const BinaryColumn column = header.is_fortran
                                    ? BinaryColumn{member.offset, sides.num_rows * item, item, member.type}
                                    : BinaryColumn{member.offset, item, sides.row_length * item, member.type};
    if (num_bytes(member.type) > 1 && member.order != points.order)
      throw io_error(file.path, fmt::format("expected one byte order, found another of {}", in_quotes(member.name)));
    for (std::size_t role = 0; role < kNumRoles; ++role) {
      if (columns.of_role[role] != i) continue;
      if (member.count != 1)
        throw io_error(file.path,
                       fmt::format("expected one number of {}, found {}", in_quotes(member.name), member.count));
      points.columns[role] = column;
    }
    if (!with_fields || !columns.is_field(i)) continue;
    table.fields.push_back({member.name, member.type, member.count, {}});
    points.fields.push_back(column);
  }
  table.has_normals = columns.has_normals();
  table.has_intensities = columns.has_intensities();
}

}  // namespace

CloudFile parse_npy(const FileBytes& file, const ReadOptions& options) {
  const NpyHeader header = parse_npy_header(file);
  const std::uint64_t array_bytes = checked_num_items(file, header) * header.item_bytes;
  const Sides sides = sides_of(header);
  check_num_points(file.path, sides.num_points(), options);

  const std::string_view body = std::string_view(file.bytes).substr(header.body_offset, array_bytes);
  const std::string floats = header.is_half ? widened(body, header.order) : "";
  BinaryPoints points{body, header.order, {}, sides.num_rows, sides.row_length};
  if (header.is_half) {
    points.bytes = floats;
    points.order = kNativeOrder;
  }
  PointTable table;
  table.format = header.is_structured() ? "npy structured" : "npy";
  table.num_points = sides.num_points();
  const bool has_rows = header.shape.size() == (header.is_structured() ? 2u : 3u);
  table.width = has_rows ? static_cast<int>(sides.row_length) : 0;
  if (header.is_structured()) {
    points.order = order_of(header.members);
    add_members(file, header, sides, options.keep_fields, points, table);
  } else {
    add_plain_columns(header, sides, options.keep_fields, points, table);
  }
  CloudFile read = build_cloud(file, table, [&](CloudBuilder& builder) { add_points(points, builder); });
  if (const std::uint64_t excess = file.bytes.size() - header.body_offset - array_bytes; excess > 0)
    read.report.warnings.push_back(fmt::format("{} bytes after the array were not read", excess));
  return read;
}

}  // namespace augicp
