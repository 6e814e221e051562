// SPDX-License-Identifier: MIT
#pragma once

#include "augicp/io/depth_sequence.h"
#include "augicp/io/file_bytes.h"

namespace augicp {

// The lines "stamp path" of a TUM list of images. Paths may have blanks and become relative to the list's folder.
// Stamps are finite, in any order and unit. Throws IoError naming the line.
std::vector<DepthFrameFile> parse_image_list(const FileBytes& list);

// The files of a folder whose names end in a number before `ending` (in any case), ordered by that number. The stamp is
// the number itself if it has a decimal point, else number / frames_per_s. Throws IoError if two files have the same
// number, and if a number has too many digits for a stamp in seconds.
std::vector<DepthFrameFile> numbered_files(const std::filesystem::path& folder, std::string_view ending,
                                           double frames_per_s);

// The images of the first of the known kinds (.png .pgm .npy .pfm .tif .tiff) of which a folder has any with a number,
// see numbered_files(). left_out: in words, the images that are not among them; empty if there are none.
struct NumberedImages {
  std::vector<DepthFrameFile> frames;
  std::string left_out;
};
NumberedImages numbered_images(const std::filesystem::path& folder, double frames_per_s);

}  // namespace augicp
