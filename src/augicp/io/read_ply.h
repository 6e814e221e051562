// SPDX-License-Identifier: MIT
#pragma once

#include "augicp/io/cloud_file.h"
#include "augicp/io/file_bytes.h"

namespace augicp {

// The points of a PLY file: its element "vertex". Other elements, such as faces, are checked for completeness and
// skipped. Throws IoError.
CloudFile parse_ply(const FileBytes& file, const ReadOptions& options = {});

}  // namespace augicp
