// SPDX-License-Identifier: MIT
#pragma once

#include "augicp/io/depth_sequence.h"
#include "augicp/io/file_bytes.h"

namespace augicp {

// The lines "stamp path" of a TUM list of images. Paths may have blanks and become relative to the list's folder.
// Stamps may have any order. Throws IoError naming the line.
std::vector<DepthFrameFile> parse_image_list(const FileBytes& list);

// The files of a folder whose names end in a number before `ending` (in any case), ordered by that number. The stamp is
// the number itself if it has a decimal point, else number / frames_per_s. Throws IoError if two files have the same
// number, and if a number has too many digits for a stamp in seconds.
std::vector<DepthFrameFile> numbered_files(const std::filesystem::path& folder, std::string_view ending,
                                           double frames_per_s);

}  // namespace augicp
