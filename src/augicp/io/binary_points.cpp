// SPDX-License-Identifier: MIT
#include "augicp/io/binary_points.h"

namespace augicp {

void add_points(const BinaryPoints& points, CloudBuilder& builder) {
  PointValues values{};
  values[6] = static_cast<double>(Structure::Planar);  // a normal without a structure belongs to a plane
  for (std::size_t v = 0; v < points.num_rows; ++v)
    for (std::size_t u = 0; u < points.row_length; ++u) {
      for (std::size_t role = 0; role < kNumRoles; ++role)
        if (const auto& column = points.columns[role])
          values[role] = read_scalar(points.bytes.data() + column->offset + v * column->row_stride + u * column->stride,
                                     column->type, points.order);
      builder.add(values);
    }
}

}  // namespace augicp
