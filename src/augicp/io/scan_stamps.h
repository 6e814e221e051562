// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace augicp {

struct ScanStamps {
  std::vector<double> stamps_s;       // one a scan, in any order
  bool are_measured = false;          // of a list, or of the names; else made from numbers or places and a rate
  bool are_of_names = false;          // measured: the numbers in the names, which tell the order
  std::vector<std::string> warnings;  // each with the file or folder that it concerns
};

// The stamps of the scans of a folder, see read_scan_sequence(). REQUIRES: at least one scan, scans_per_s above 0.
// Throws IoError for a damaged list.
ScanStamps scan_stamps(const std::filesystem::path& folder, std::span<const std::filesystem::path> scans,
                       double scans_per_s);

}  // namespace augicp
