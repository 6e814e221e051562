// SPDX-License-Identifier: MIT
// What a file states about its points beside the arrays of a Cloud: colours, stamps, rings, classifications. Algorithms
// never see it; it goes from a reader to a writer.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "augicp/io/scalar_type.h"

namespace augicp {

// One column, with the name and the type that it has in the file.
struct PointField {
  std::string name;
  ScalarType type = ScalarType::Float32;
  std::size_t count = 1;  // numbers per row
  std::string values;     // the numbers in the machine's own byte order, row after row

  std::size_t row_bytes() const { return count * num_bytes(type); }
  std::size_t num_rows() const { return values.size() / row_bytes(); }

  // One number as a double. REQUIRES: row < num_rows(), k < count.
  double at(std::size_t row, std::size_t k = 0) const;
};

// All further columns. A row is a point of the cloud, or of an organised file a cell of the grid.
// Invariant: every field has the same number of rows.
struct PointFields {
  std::vector<PointField> fields;
  std::vector<std::string> not_kept;  // one sentence for each part of the file that is not here

  // The first field of this name, which is in lower case, whatever the case of the field's; null if there is none.
  const PointField* find(std::string_view lower_case_name) const;
};

// The same fields of these rows, in this order.
PointFields select(const PointFields& fields, const std::vector<std::uint32_t>& rows);

// ASCII letters in lower case, in any locale.
std::string lower_case(std::string_view text);

}  // namespace augicp
