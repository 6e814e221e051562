// SPDX-License-Identifier: MIT
#pragma once

#include "augicp/io/depth_sequence.h"
#include "augicp/io/file_bytes.h"

namespace augicp {

// The lines "stamp path" of a TUM list of images; paths become relative to the list's folder. Throws IoError naming the
// line. Stamps may have any order.
std::vector<DepthFrameFile> parse_image_list(const FileBytes& list);

// The files of a folder whose names end in a number before `ending`, by that number, with number / frames_per_s as stamp.
// Throws IoError where two have the same number.
std::vector<DepthFrameFile> numbered_files(const std::filesystem::path& folder, std::string_view ending,
                                           double frames_per_s);

}  // namespace augicp
