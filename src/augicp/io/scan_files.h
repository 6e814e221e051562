// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace augicp {

// The scans of a folder, see find_scans().
struct ScanFiles {
  std::vector<std::filesystem::path> scans;
  std::string left_out;  // in words: clouds of other kinds or places, which are not among the scans; empty: none.
                         // Without scans their counts alone: "3 .las, 1 .xyz"
};

// Throws IoError if the folder cannot be listed.
ScanFiles scan_files_in(const std::filesystem::path& folder);

}  // namespace augicp
