// SPDX-License-Identifier: MIT
// The further columns of a cloud in the form that a format has for them.
#pragma once

#include "augicp/cloud/index_image.h"
#include "augicp/io/cloud_file.h"

namespace augicp {

// The fields of a file that was read, those of LAS records too.
PointFields fields_of(const CloudFile& file);

// The rows of points, without those of empty cells.
PointFields without_empty_cells(const PointFields& fields, const IndexImage& grid);

// For PLY, with a sentence in not_kept for what it has no place for: packed rgb and rgba become red green blue (alpha),
// each number of a field a property of its own (name_0, name_1), and integers of 64 bits double.
PointFields fields_for_ply(PointFields fields);

// For LAS: the same, but integers of 64 bits stay.
PointFields fields_for_las(PointFields fields);

// For PCD: red green blue (alpha) of 8 bits become PCL's packed rgb or rgba.
PointFields fields_for_pcd(PointFields fields);

}  // namespace augicp
