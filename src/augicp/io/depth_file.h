// SPDX-License-Identifier: MIT
// Depth images in any format.
#pragma once

#include "augicp/io/depth_png.h"

namespace augicp {

// Whether the extension is one of images, also of those that are refused (.exr, .jpg). (.npy has clouds too.)
bool is_image_file(const std::filesystem::path& path);

// A depth image by its extension:
//   .png  16-bit grey, see depth_png.h
//   .pgm  16-bit grey, binary (P5); values as in a PNG
//   .pfm  one channel, metres
//   .tif  one channel of 16 or 32 bits: integers as in a PNG, floats in metres; see tiff_directory.h
//   .npy  (H, W): float16, float32 or float64 metres; integers as in a PNG. A further side of 1 is ignored.
// Images have at most 16384 pixels a side. Throws IoError, and std::invalid_argument unless depth_scale is above 0.
DepthImage read_depth_image(const std::filesystem::path& path, double depth_scale);

// The same for a file in memory.
DepthImage parse_depth_image(const FileBytes& file, double depth_scale);

}  // namespace augicp
