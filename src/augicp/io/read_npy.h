// SPDX-License-Identifier: MIT
#pragma once

#include "augicp/io/cloud_file.h"
#include "augicp/io/file_bytes.h"

namespace augicp {

// A NumPy array of float32 or float64, versions 1.0 to 3.0, either byte order, C or Fortran order. Shape (N, 3 or
// more): the first three columns are the points. Shape (H, W, 3 or more): the same, with a grid. Throws IoError.
CloudFile parse_npy(const FileBytes& file, const ReadOptions& options = {});

}  // namespace augicp
