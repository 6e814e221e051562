// SPDX-License-Identifier: MIT
// The rows that the PLY and the PCD writer have in common.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "augicp/io/atomic_file.h"
#include "augicp/io/scalar_type.h"
#include "augicp/io/write_cloud.h"

namespace augicp {

struct RowColumn {
  const char* name;
  ScalarType type;
};

// The columns of a cloud: x y z, as double where an origin must be added; nx ny nz and structure where it has
// directions; intensity where it has any; red green blue where colours has any. Throws std::invalid_argument for a
// cloud without points, and where colours, structures or intensities are not as many as the points.
std::vector<RowColumn> row_columns(const Cloud& cloud, std::span<const Colour> colours);

// Writes all rows: packed little-endian records, or lines of numbers with as many digits as they need.
void write_rows(AtomicFile& file, const Cloud& cloud, std::span<const Colour> colours, FileEncoding encoding);

}  // namespace augicp
