// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>

#include "augicp/io/cloud_file.h"
#include "augicp/io/file_bytes.h"

namespace augicp {

// Reads the cloud in a file: .ply, .pcd, .las, .xyz .txt .csv .pts, KITTI's .bin or .npy, by the extension; the content
// is checked. "drive.mcap#12" and "drive.mcap#/points#12" are messages PointCloud2 of a recording (.bag, .db3, .mcap or
// a folder of rosbag2), counted from 0; the topic may be left out if it is the only one of clouds. Throws IoError for a
// file that is damaged, cut short, without points or without any finite point. Memory: the file, its content if it is
// compressed, and the cloud, so about three times the file at most, except for coordinates of one or two bytes.
//
// A few cuts are undetectable and are no errors: in text, within the last number, or at a line of a file that states no
// count (both with a warning if the last line has no end); in .bin, at a whole number of points.
CloudFile read_cloud(const std::filesystem::path& path, const ReadOptions& options = {});

// The same for a file in memory.
CloudFile parse_cloud(const FileBytes& file, const ReadOptions& options = {});

}  // namespace augicp
