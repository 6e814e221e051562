// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string_view>
#include <vector>

#include "augicp/io/cloud_builder.h"
#include "augicp/io/scalar_type.h"

namespace augicp {

// The positions of the numbers of one column, in bytes: the number of the point in row v and place u of its row is at
// offset + v * row_stride + u * stride. Files without rows have one row.
struct BinaryColumn {
  std::size_t offset = 0;
  std::size_t stride = 0;
  std::size_t row_stride = 0;
  ScalarType type = ScalarType::Float32;

  std::size_t at(std::size_t v, std::size_t u) const { return offset + v * row_stride + u * stride; }
};

// Points in memory, as consecutive records or columns. REQUIRES: bytes outlives this and contains every number that the
// columns address.
struct BinaryPoints {
  std::string_view bytes;
  ByteOrder order = ByteOrder::Little;
  std::array<std::optional<BinaryColumn>, kNumRoles> columns;  // by role
  std::size_t num_rows = 1;
  std::size_t row_length = 0;
  std::vector<BinaryColumn> fields{};  // the first number of each of PointTable::fields; its others follow it
};

void add_points(const BinaryPoints& points, CloudBuilder& builder);

}  // namespace augicp
