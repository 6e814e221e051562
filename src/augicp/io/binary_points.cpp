// SPDX-License-Identifier: MIT
#include "augicp/io/binary_points.h"

namespace augicp {
namespace {

void append(const BinaryPoints& points, const BinaryColumn& column, std::size_t offset, PointField& field) {
  const std::size_t size = num_bytes(field.type);
  for (std::size_t k = 0; k < field.count; ++k) {
    char number[8];
    copy_scalar(points.bytes.data() + offset + k * size, column.type, points.order, number);
    field.values.append(number, size);
  }
}

}  // namespace

void add_points(const BinaryPoints& points, CloudBuilder& builder) {
  PointValues values{};
  values[6] = static_cast<double>(Structure::Planar);  // a normal without a structure belongs to a plane
  for (std::size_t v = 0; v < points.num_rows; ++v)
    for (std::size_t u = 0; u < points.row_length; ++u) {
      for (std::size_t role = 0; role < kNumRoles; ++role)
        if (const auto& column = points.columns[role])
          values[role] = read_scalar(points.bytes.data() + column->at(v, u), column->type, points.order);
      if (!builder.add(values)) continue;
      for (std::size_t i = 0; i < points.fields.size(); ++i)
        append(points, points.fields[i], points.fields[i].at(v, u), builder.fields()[i]);
    }
}

}  // namespace augicp
