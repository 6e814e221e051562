// SPDX-License-Identifier: MIT
#pragma once

#include "augicp/io/cloud_file.h"
#include "augicp/io/file_bytes.h"

namespace augicp {

// LAS 1.0 to 1.4, point formats 0 to 10. Throws IoError, also for compressed points (LAZ, COPC).
CloudFile parse_las(const FileBytes& file, const ReadOptions& options);

}  // namespace augicp
