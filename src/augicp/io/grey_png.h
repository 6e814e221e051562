// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>

#include "augicp/io/file_bytes.h"
#include "augicp/sensor/grey_image.h"

namespace augicp {

// Brightness of the pixels of a PNG of 8-bit grey, RGB or RGBA values, from 0 to 1. Of colours, the luma of ITU-R
// BT.601, 0.299 R + 0.587 G + 0.114 B, for any opacity. Throws IoError for any other kind of PNG and for a damaged one.
GreyImage read_grey_png(const std::filesystem::path& path);

// The same from the bytes of a file.
GreyImage parse_grey_png(const FileBytes& file);

}  // namespace augicp
