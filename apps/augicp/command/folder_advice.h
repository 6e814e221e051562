// SPDX-License-Identifier: MIT
// What can be done with a folder that is not what was expected.
#pragma once

#include <filesystem>
#include <string>

namespace augicp::app {

// For a folder in the place of a file: its two clouds are aligned, and more of them are tracked, in the folder that has
// them.
std::string folder_advice(const std::filesystem::path& folder);

// Throws IoError if a folder to track has neither scans nor images of its own, and names a folder below it that has.
void require_frames(const std::filesystem::path& folder);

}  // namespace augicp::app
