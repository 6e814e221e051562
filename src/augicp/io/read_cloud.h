// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>

#include "augicp/io/cloud_file.h"
#include "augicp/io/file_bytes.h"

namespace augicp {

// The cloud in a file: .ply, .pcd, .xyz .txt .csv .pts, KITTI's .bin or .npy, told by the extension and checked by the
// content. Throws IoError, with nothing read, for a file that is damaged, cut short, without points or without any
// finite point. Takes memory for the file (and its content, where that is compressed) and for the cloud, nothing more:
// about three times the file at most, but for coordinates in single bytes.
//
// A few cuts cannot be seen and are not errors: in text, within the last number, or at a line of a file that states no
// count (both with a warning where the last line has no end); in .bin, at a whole number of points.
CloudFile read_cloud(const std::filesystem::path& path, const ReadOptions& options = {});

// The same for a file that is in memory.
CloudFile parse_cloud(const FileBytes& file, const ReadOptions& options = {});

}  // namespace augicp
