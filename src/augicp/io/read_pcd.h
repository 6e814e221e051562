// SPDX-License-Identifier: MIT
#pragma once

#include "augicp/io/cloud_file.h"
#include "augicp/io/file_bytes.h"

namespace augicp {

// A PCD file, versions 0.5 to 0.7, ascii, binary or binary_compressed. Several rows (HEIGHT above 1) make a grid. A
// VIEWPOINT other than the default becomes the viewpoint of the cloud. Throws IoError.
CloudFile parse_pcd(const FileBytes& file, const ReadOptions& options = {});

}  // namespace augicp
