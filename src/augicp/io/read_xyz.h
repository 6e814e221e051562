// SPDX-License-Identifier: MIT
#pragma once

#include "augicp/io/cloud_file.h"
#include "augicp/io/file_bytes.h"

namespace augicp {

// Text with one point per line (.xyz .txt .csv .pts .asc .xyzn .xyzrgb): x y z and further columns, separated by
// blanks, commas or semicolons; '#', '%' or '//' starts a comment line. The first line may name the columns, which may
// then have any order and include normals, or state the number of points; see text_columns.h. Throws IoError.
CloudFile parse_xyz(const FileBytes& file, const ReadOptions& options = {});

}  // namespace augicp
