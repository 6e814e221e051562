// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "augicp/io/cloud_file.h"

namespace augicp {

// Writes the cloud as LAS. A cloud that was read from LAS with its fields is written with its header, records and extra
// bytes as they were, except for positions and bounds; its scale is kept, its offset too unless the positions do not
// fit. Any other becomes LAS 1.4 of point format 6, or 7 with colours, in steps of a billionth of its extent; columns
// that LAS knows are in their places, others in extra bytes. Returns a sentence for each part that is not kept. Throws
// IoError, and std::invalid_argument for a cloud without points.
std::vector<std::string> write_las(const std::filesystem::path& path, const CloudFile& file);

// The records of such another file, with positions of zero.
LasRecords las_records_of(const CloudFile& file);

}  // namespace augicp
