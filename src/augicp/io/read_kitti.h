// SPDX-License-Identifier: MIT
#pragma once

#include "augicp/io/cloud_file.h"
#include "augicp/io/file_bytes.h"

namespace augicp {

// Points of float32 numbers without a header, as in KITTI's and nuScenes' files. The format has no signature. But
// numbers behind the coordinates (intensities, rings, times) are never negative, and coordinates are. Without a stated
// number of columns, the first of 4, 5 and 6 that divides the file and has no negative number there is taken, with a
// warning if another would do too. Throws IoError if none does; throws std::invalid_argument for other numbers of
// columns than 0 and 3 to 6.
CloudFile parse_kitti(const FileBytes& file, const ReadOptions& options);

}  // namespace augicp
