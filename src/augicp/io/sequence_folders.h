// SPDX-License-Identifier: MIT
#pragma once

#include "augicp/io/depth_sequence.h"
#include "augicp/io/file_bytes.h"

namespace augicp {

// The lines "stamp path" of a TUM list of images; paths, which may have blanks, become relative to the list's folder.
// Throws IoError naming the line. Stamps may have any order.
std::vector<DepthFrameFile> parse_image_list(const FileBytes& list);

// The files of a folder whose names end in a number before `ending` (in any case), by that number. The stamp is the
// number itself where it has a decimal point, else number / frames_per_s. Throws IoError where two have the same
// number, and where a number has too many digits for a stamp in seconds.
std::vector<DepthFrameFile> numbered_files(const std::filesystem::path& folder, std::string_view ending,
                                           double frames_per_s);

}  // namespace augicp
