// SPDX-License-Identifier: MIT
// Rows shared by the PLY and the PCD writer.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "augicp/cloud/cloud.h"
#include "augicp/cloud/index_image.h"
#include "augicp/io/atomic_file.h"
#include "augicp/io/point_fields.h"
#include "augicp/io/write_cloud.h"

namespace augicp {

// A column without its values.
struct RowColumn {
  std::string name;
  ScalarType type = ScalarType::Float32;
  std::size_t count = 1;
};

// A row of the file: the point in it, or none in an empty cell of a grid, and the row of the fields.
struct Row {
  std::int32_t point = IndexImage::kNone;
  std::size_t of_fields = 0;
};

// Neighbouring columns that one function writes: packed little-endian, or numbers with the shortest digits that read
// back exactly, each followed by a blank.
struct RowPart {
  std::vector<RowColumn> columns;
  std::function<void(const Row&, std::string& out)> append;
};

// The columns of a cloud and its fields: x y z, as float if that keeps the cloud's details (see spread.h) and else as
// double; if it has directions nx ny nz, the structure, and if it has edges tangent_x tangent_y tangent_z, each zero
// where the point has none; its intensities unless the fields have them; the fields. Throws std::invalid_argument for a
// cloud without points, and if a number of structures, intensities or rows does not fit. REQUIRES: cloud and fields
// outlive the parts.
std::vector<RowPart> row_parts(const Cloud& cloud, const PointFields& fields, const IndexImage* grid,
                               FileEncoding encoding);

std::vector<RowColumn> columns_of(const std::vector<RowPart>& parts);

// Writes the rows of all points, or of all cells of a grid.
void write_rows(AtomicFile& file, const std::vector<RowPart>& parts, std::size_t num_points, const IndexImage* grid,
                FileEncoding encoding);

}  // namespace augicp
