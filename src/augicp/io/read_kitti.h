// SPDX-License-Identifier: MIT
#pragma once

#include "augicp/io/cloud_file.h"
#include "augicp/io/file_bytes.h"

namespace augicp {

// A LiDAR sweep as KITTI stores it: float32 x y z intensity, little endian, with the sensor at zero (the viewpoint).
// With options.num_bin_columns = 3: positions x y z of an unknown viewpoint. Throws IoError.
CloudFile parse_kitti(const FileBytes& file, const ReadOptions& options = {});

}  // namespace augicp
