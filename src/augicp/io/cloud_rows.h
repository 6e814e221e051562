// SPDX-License-Identifier: MIT
// Rows shared by the PLY and the PCD writer.
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

// The columns of a cloud: x y z, as double if there is an origin to add; nx ny nz and structure if it has directions;
// intensity if it has intensities; red green blue if colours is not empty. Throws std::invalid_argument for a cloud
// without points, and if the number of colours, structures or intensities differs from the number of points.
std::vector<RowColumn> row_columns(const Cloud& cloud, std::span<const Colour> colours);

// Writes all rows: packed little-endian records, or lines of numbers with the shortest digits that read back exactly.
void write_rows(AtomicFile& file, const Cloud& cloud, std::span<const Colour> colours, FileEncoding encoding);

}  // namespace augicp
