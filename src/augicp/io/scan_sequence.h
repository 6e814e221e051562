// SPDX-License-Identifier: MIT
// Folders of LiDAR scans.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace augicp {

struct ScanFile {
  double stamp_s = 0.0;
  std::filesystem::path path;
};

struct ScanSequence {
  bool has_stamps = false;      // from a list; else the stamps are made from numbers and a rate
  std::string layout;           // "KITTI odometry", "KITTI raw" or "scans"
  std::vector<ScanFile> scans;  // in natural order (2.bin before 10.bin), unless stamps are given in that of the stamps
};

// The .bin, .pcd and .ply files of a folder, of its folder velodyne/ (KITTI odometry) or of its folder
// velodyne_points/data/ (KITTI raw); of several kinds of files, the one of which there are most. Empty if there are
// none. Throws IoError if the folder cannot be listed.
std::vector<std::filesystem::path> find_scans(const std::filesystem::path& folder);

// The scans with their stamps: from times.txt (seconds, a line a scan) beside the scans or in a folder above, or from
// KITTI raw's timestamps.txt; else the number in which each name ends / scans_per_s, if all names have one and they
// ascend; else the place / scans_per_s. Scans are not opened. Throws IoError if there are no scans, if a list of stamps
// has not as many as there are scans or does not ascend, and std::invalid_argument unless scans_per_s is above 0.
ScanSequence read_scan_sequence(const std::filesystem::path& folder, double scans_per_s);

}  // namespace augicp
