// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include "augicp/io/tiff_directory.h"

namespace augicp {

// The content of compressed bytes, which has this size; empty if they are damaged, or have less. More is ignored, as
// some writers fill strips up. Memory: the content.
std::optional<std::string> decompressed_block(TiffCompression compression, std::string_view bytes, std::size_t size);

// Undoes the predictor in rows of pixels, in place. A floating-point predictor leaves the most significant byte of each
// pixel in front, whatever the order of the file.
void undo_predictor(const TiffImage& image, std::string& rows);

}  // namespace augicp
